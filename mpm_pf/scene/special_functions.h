// What muParser lacks of the functions in which the theory of diffusion is written; scenes and
// checks know the same ones.
#pragma once

#include <cmath>

namespace scene
{
  inline double error_function(const double x)
  {
    return std::erf(x);
  }
  inline double complementary_error_function(const double x)
  {
    return std::erfc(x);
  }
  /// E1(x), the integral of exp(-s)/s from x to infinity, x > 0.
  inline double exponential_integral(const double x)
  {
    return -std::expint(-x);
  }
} // namespace scene
