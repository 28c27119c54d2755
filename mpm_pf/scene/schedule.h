// When a probe samples: the one rule that both solvers follow, so that their tables have the same
// rows.
#pragma once

#include <vector>

#include "scene/probes.h"

namespace scene
{
  /// Scenes are written with rounded numbers: what is past the end by no more than this fraction of
  /// it is meant to be the end.
  inline constexpr double rounding_of_times = 1e-9;

  /// Sorted times of `probe` in [0, end]: its explicit times; or 0, every, 2 every, ... and the
  /// end; with neither, the end alone for lines, outlines and snapshots, and 201 equal samples for
  /// whatever is a history. Empty for a probe that samples at compressions instead.
  std::vector<double> sample_times(const Probe &probe, double end);

  /// Time between two samples of a probe at regular intervals; end/200 unless it says otherwise.
  double sample_interval(const Probe &probe, double end);
} // namespace scene
