// Distance between what was measured and what it is held against; always unsigned (README.md lists
// the norms).
#pragma once

#include <optional>
#include <string>

#include "quantity.h"

namespace verify
{
  struct Norm
  {
    std::string name;
    std::optional<double> scale; // divides the norm instead of the size of the reference
    double coverage = 0.;        // of curves, 0 to 1
  };

  /// Distance of `a` from the reference `b`. Relative norms are divided by the size of `size_of`
  /// (the reference of the check, also where two grids of one code are compared). Throws
  /// MissingData for data that are absent, short, not finite or of unlike kind, and where a
  /// relative norm has a reference of size zero or the scale is zero.
  double distance(const Norm &, const Quantity &a, const Quantity &b, const Quantity &size_of);
} // namespace verify
