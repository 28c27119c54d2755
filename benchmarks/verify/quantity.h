// What a take gives: a number, a curve or outlines; and how it says that it cannot.
#pragma once

#include <stdexcept>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace verify
{
  /// Data are absent, short or not finite: the check that needs them has the status "missing" and
  /// fails.
  struct MissingData : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };
  /// The reference itself is absent: status "no reference", exit code 4.
  struct MissingReference : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /// y over x; t is the time of each sample (equal to one time throughout for a profile). NaN in y:
  /// no material there (line probes only).
  struct Curve
  {
    std::vector<double> x, y, t;
  };
  using Outline = std::vector<scene::Polyline>;
  using Quantity = std::variant<double, Curve, Outline>;
} // namespace verify
