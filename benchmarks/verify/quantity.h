// What a take gives: a number, a curve, outlines or a raster; and how it says that it cannot.
#pragma once

#include <array>
#include <map>
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
  /// Means over squares; the square (i, j) of side b covers [i b, (i + 1) b] x [j b, (j + 1) b].
  struct Raster
  {
    std::map<std::array<int, 2>, double> mean;
  };
  using Quantity = std::variant<double, Curve, Outline, Raster>;
} // namespace verify
