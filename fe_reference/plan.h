// What a run will cost, before any of it: cells, unknowns, load steps, memory, time.
#pragma once

#include <string>
#include <vector>

#include "assembly.h"

namespace fe
{
  struct Plan
  {
    int cells = 0, unknowns = 0, integration_points = 0, load_steps = 0;
    double factor_bytes = 0., state_bytes = 0., tangent_bytes = 0.;
    double seconds = 0.;        // of CPU
    double resident_bytes = 0.; // of one process; 0: not foretold
  };

  /// Estimated from the mesh alone. Nested dissection in the plane fills about 8 n log2(n) entries
  /// and costs about 30 n^1.5 operations a factorisation; three iterations a load step.
  Plan make_plan(const QuadMesh &, const scene::Scene &);

  /// Replaces the estimate of time by what the first load steps of the problem cost on this
  /// machine, and that of resident memory by what they took; every sampling time ends a step.
  void time_first_steps(Plan &, const Problem &, const scene::Scene &,
                        const std::vector<double> &sampling_times);

  /// For people, and one line that programs read: `forecast cpu_s=... solver_bytes=...
  /// resident_bytes=...`.
  std::string describe(const Plan &);
} // namespace fe
