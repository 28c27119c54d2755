// Curves sampled by two programs at different places, and how to compare or reduce them.
#pragma once

#include <string>
#include <vector>

#include "quantity.h"

namespace verify
{
  /// y at `x`, linear between samples; NaN outside the samples (beyond 1e-9 of their range) or
  /// beside a NaN. The abscissa must be monotone, either way.
  double interpolate(const Curve &, double x);

  /// Cuts a curve whose abscissa turns round (a loading loop) into its monotone branches. Reversals
  /// smaller than 1e-3 of the abscissa's range are noise and do not cut.
  std::vector<Curve> branches(const Curve &);

  /// Two curves at common abscissas: those of b, branch by branch. Where either is NaN both are
  /// left out.
  struct CommonSamples
  {
    std::vector<double> x, a, b;
    std::vector<std::size_t> start; // first sample of each branch
  };

  /// Throws MissingData if the branches differ in number, a value is infinite, or the part where
  /// both have values is less than `coverage` (0 to 1) of that where either has.
  CommonSamples common_samples(const Curve &a, const Curve &b, double coverage);

  /// Trapezoidal weights of the samples over |dx|, branch by branch; equal weights if the abscissa
  /// has no extent.
  std::vector<double> weights(const CommonSamples &);

  /// The stretch of the curve with key (its time, or its abscissa) within [from, to].
  Curve between(const Curve &, bool by_time, double from, double to);

  /// max, min, max_abs, mean, rms, first, last, range, slope, integral, ripple; see README. Throws
  /// MissingData if no finite sample is left.
  double reduce(const Curve &, const std::string &how);
} // namespace verify
