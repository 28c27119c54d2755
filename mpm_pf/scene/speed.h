// The largest speed of a prescribed motion, for whatever is set by it: scaled densities, presets.
#pragma once

#include <functional>
#include <vector>

#include "scene/domain.h"

namespace scene
{
  /// `count` increasing times in (0, end], the last of them the end, spaced unevenly, so that no
  /// period of a motion hides between them.
  std::vector<double> uneven_times(double end, int count);

  /// Largest speed of `at`(t) over [0, end]. Looked for between several hundred uneven times, and
  /// from the fastest intervals down to a millionth of the
  /// end: a ramp much shorter than the run counts with its own slope.
  double largest_speed(const std::function<Point(double)> &at, double end);
} // namespace scene
