// What a run will cost, before any of it: cells, unknowns, load steps, memory, time.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "assembly.h"

namespace fe
{
  struct Plan
  {
    int cells = 0, unknowns = 0, integration_points = 0, load_steps = 0;
    std::map<std::string, double> bytes; // by what they are for, see memory.h
    double seconds = 0.;                 // of CPU
    double resident_bytes = 0.;          // of one process; 0: not predicted
    std::string trouble;                 // what stopped its steps: the run will meet it as well
  };

  /// Counts the problem and takes its first load steps: what these cost and hold on this machine is
  /// carried on to the end; every sampling time ends a step. None goes beyond clock.end.
  Plan make_plan(const Problem &, const scene::Scene &, const std::vector<double> &sampling_times);

  /// How far the supports move against each other from 0 to `end`, over the side of a mean cell
  /// (which perfectly plastic flow concentrates in), in yield strains sigma_Y/E; summed over
  /// `load_steps` equal increments. 0 for what is elastic or what no support moves.
  double yield_strains(const Problem &, double end, int load_steps);

  /// For people, and one line that programs read: `forecast cpu_s=... solver_bytes=...
  /// resident_bytes=...`.
  std::string describe(const Plan &);
} // namespace fe
