// Mean nodal velocity over a call: displacement over duration, free of elastic ringing.
#pragma once

#include "solid/grid.h"
#include "solid/solid.h"

namespace solid
{
  void reset(NodalVelocity &, const scene::Domain &);
  /// Add one step's transferred velocity p_i/m_i and mass with a weight (step over duration). A
  /// velocity counts with the mass that carries it, so `finish` must divide.
  void add(NodalVelocity &, const Grid &, const scene::Domain &, double weight);
  void finish(NodalVelocity &);
} // namespace solid
