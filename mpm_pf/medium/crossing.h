// Where a nodal field crosses zero on a mesh line, to well below a cell.
//
// Across a solidification front phi = tanh(d/(sqrt(2) W0)), d the distance to the front: a curved
// profile of a straight quantity. Interpolating atanh(phi) instead of phi removes that curvature
// (Ref. [14] of the paper). Here atanh is replaced by its [5/4] Pade approximant
//   g(x) = x (945 - 735 x^2 + 64 x^4)/(945 - 1050 x^2 + 225 x^4) = atanh(x) + O(x^11),
// which has the same zero, stays smooth and finite where atanh diverges (g(1) = 137/60), and so
// needs no clipping and no logarithm. Between two nodes the crossing is the root of the cubic
// through four.
#pragma once

#include <algorithm>
#include <cmath>

namespace medium
{
  /// How a field runs across its zero: as the tanh of a distance, or straight like a distance.
  enum class Profile
  {
    tanh_of_distance,
    straight
  };

  /// Straightened phase field g(phi), dimensionless; distance/(sqrt(2) W0) near the front. Values
  /// beyond +-1.05 count as +-1.05.
  inline double straightened(double phi)
  {
    const double x = std::min(std::max(phi, -1.05), 1.05), square = x * x;
    return x * (945. + square * (-735. + 64. * square)) /
           (945. + square * (-1050. + 225. * square));
  }

  /// Cubic through f[0..3] at the places -1, 0, 1, 2: coefficients of 1, s, s^2, s^3.
  struct Cubic
  {
    explicit Cubic(const double *f)
        : c0(f[1]), c1(-f[0] / 3. - f[1] / 2. + f[2] - f[3] / 6.),
          c2((f[0] - 2. * f[1] + f[2]) / 2.), c3((f[3] - f[0]) / 6. + (f[1] - f[2]) / 2.)
    {
    }
    double value(double s) const { return c0 + s * (c1 + s * (c2 + s * c3)); }
    double slope(double s) const { return c1 + s * (2. * c2 + s * 3. * c3); }
    double second_derivative(double s) const { return 2. * c2 + 6. * c3 * s; }
    double c0, c1, c2, c3;
  };

  /// Root of the cubic in [0, 1] where its values at 0 and 1 differ in sign: Newton's method kept
  /// inside a shrinking bracket. About 1e-13 off, in units of the spacing.
  inline double root_between(const Cubic &f)
  {
    const double end = f.value(1.);
    double low = 0., high = 1., s = f.c0 / (f.c0 - end);
    for (int step = 0; step < 40; ++step)
    {
      const double value = f.value(s), slope = f.slope(s);
      if (std::abs(value) <= 1e-13 * std::abs(slope))
        break;
      ((value < 0.) == (f.c0 < 0.) ? low : high) = s;
      const double next = slope != 0. ? s - value / slope : low;
      s = next > low && next < high ? next : 0.5 * (low + high);
    }
    return s;
  }
} // namespace medium
