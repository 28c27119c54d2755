// An equilibrium and the pace of the march, saved so that a run goes on to the same bits.
#pragma once

#include "observer.h"
#include "record/checkpoint.h"

namespace fe
{
  /// Every process must call it; process 0 writes. `points` are gathered from all.
  void save(const std::string &path, const scene::Scene &, const Problem &, const State &,
            const Pace &, const Folding &);

  struct Saved
  {
    State state;
    Pace pace;
    Folding folding;
  };
  /// Throws std::runtime_error if there is no such file, it belongs to another scene or to another
  /// mesh.
  Saved load(const std::string &path, const scene::Scene &, const Problem &);
} // namespace fe
