// What a run will cost, before any of it: cells, unknowns, load steps, memory, time.
#pragma once

#include <string>

#include "assembly.h"

namespace fe
{
  struct Plan
  {
    int cells = 0, unknowns = 0, integration_points = 0, load_steps = 0;
    double factor_bytes = 0., state_bytes = 0., tangent_bytes = 0.;
    double seconds = 0.;
  };

  /// Estimated from the mesh alone. Nested dissection in the plane fills about 8 n log2(n) entries
  /// and costs about 30 n^1.5 operations a factorisation; three iterations a load step.
  Plan make_plan(const QuadMesh &, const scene::Scene &);

  std::string describe(const Plan &);
} // namespace fe
