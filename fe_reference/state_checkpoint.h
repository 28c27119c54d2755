// An equilibrium and the state of the load stepping, saved so that a run goes on to the same bits.
#pragma once

#include "observer.h"
#include "record/run_cost.h"

namespace fe
{
  /// Every process must call it; process 0 writes. `points` are gathered from all.
  struct StateToSave
  {
    const State &state;
    const SteppingState &stepping;
    const Folding &folding;
    const record::Profile &spent; // until now; of process 0
  };
  void save(const std::string &path, const scene::Scene &, const Problem &, const StateToSave &);

  struct SavedState
  {
    State state;
    SteppingState stepping;
    Folding folding;
  };
  /// `cost` goes on from what was spent until then. Throws std::runtime_error if there is no such
  /// file, it belongs to another scene or to another mesh.
  SavedState load(const std::string &path, const scene::Scene &, const Problem &,
                  record::RunCost &cost);
} // namespace fe
