// The largest speed of a prescribed motion, for whatever is set by it: scaled densities, presets.
#pragma once

#include <functional>

#include "scene/domain.h"

namespace scene
{
  /// Largest speed of `at`(t) over [0, end]. Looked for between several hundred uneven times, so
  /// that no period hides between them, and from the fastest intervals down to a millionth of the
  /// end: a ramp much shorter than the run counts with its own slope.
  double largest_speed(const std::function<Point(double)> &at, double end);
} // namespace scene
