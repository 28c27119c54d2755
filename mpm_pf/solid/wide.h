// Eight points side by side: weights of a run of points that share their nearest node.
//
// Points are kept in the order of their nodes, so the points of one node follow each other. A
// vector holds one quantity of eight of them; what each node gets is summed over the vector at the
// end, five sums at once.
#pragma once

#include <cstring>

#include "solid/grid.h"
#include "solid/shape_functions.h"

namespace solid
{
  inline constexpr std::size_t wide = 8;

  /// Eight values from memory, aligned or not.
  inline __attribute__((always_inline)) Lanes load(const double *from)
  {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }

  struct WideWeights
  {
    Lanes w[3], g[3], d[3];
  };

  /// As weights() of shape_functions.h, for eight points.
  template <Shape shape>
  inline __attribute__((always_inline)) WideWeights
  wide_weights(const Lanes &s, const double dx, const double inverse_dx, const double half_size)
  {
    Lanes left, right, left_slope, right_slope;
    const Lanes none{};
    if constexpr (shape == Shape::quadratic_bspline)
    {
      const Lanes a = 0.5 - s, b = 0.5 + s;
      left = 0.5 * a * a, right = 0.5 * b * b, left_slope = -a, right_slope = b;
    }
    else if constexpr (shape == Shape::ugimp)
    {
      const double l = half_size, scale = 0.25 / l;
      const Lanes whole = none + 2. * l;
      Lanes a = l - s, b = l + s;
      a = a > none ? a : none, b = b > none ? b : none;
      a = a < whole ? a : whole, b = b < whole ? b : whole;
      const Lanes beyond_left = -s - l, beyond_right = s - l;
      left = a * a * scale + (beyond_left > none ? beyond_left : none);
      right = b * b * scale + (beyond_right > none ? beyond_right : none);
      left_slope = -2. * scale * a, right_slope = 2. * scale * b;
    }
    else
    {
      const Lanes one = none + 1.;
      left = s < none ? -s : none, right = s > none ? s : none;
      left_slope = s < none ? -one : none, right_slope = s < none ? none : one;
    }
    const Lanes x = s * dx;
    return {{left, 1. - left - right, right},
            {left_slope * inverse_dx, -(left_slope + right_slope) * inverse_dx,
             right_slope * inverse_dx},
            {-dx - x, -x, dx - x}};
  }

  /// {sum of a, of b, of c, of d, of e, 0, 0, 0}.
  inline __attribute__((always_inline)) Lanes sums(const Lanes &a, const Lanes &b, const Lanes &c,
                                                   const Lanes &d, const Lanes &e)
  {
    const auto pairs = [](const Lanes &x, const Lanes &y)
    {
      return Lanes(__builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14)) +
             Lanes(__builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15));
    };
    const auto fours = [](const Lanes &x, const Lanes &y)
    {
      return Lanes(__builtin_shufflevector(x, y, 0, 1, 8, 9, 4, 5, 12, 13)) +
             Lanes(__builtin_shufflevector(x, y, 2, 3, 10, 11, 6, 7, 14, 15));
    };
    const Lanes none{};
    const Lanes abcd = fours(pairs(a, b), pairs(c, d)), last = fours(pairs(e, none), none);
    return Lanes(__builtin_shufflevector(abcd, last, 0, 1, 2, 3, 8, 9, 10, 11)) +
           Lanes(__builtin_shufflevector(abcd, last, 4, 5, 6, 7, 12, 13, 14, 15));
  }

  /// Places in the grid of a chunk of points: nearest node and distance from it in cells.
  struct Located
  {
    static constexpr std::size_t most = 256;
    alignas(64) double s[most + wide] = {}, t[most + wide] = {};
    std::int32_t i[most + 1], j[most + 1];

    void locate(const Grid &grid, const Points &points, const std::size_t begin,
                const std::size_t count)
    {
      const double *const x = &points.x[begin], *const y = &points.y[begin];
      const double x0 = grid.lower[0], y0 = grid.lower[1], scale = grid.inverse_dx;
#pragma omp simd
      for (std::size_t k = 0; k < count; ++k)
      {
        const double a = (x[k] - x0) * scale, b = (y[k] - y0) * scale;
        const double nearest_a = std::floor(a + 0.5), nearest_b = std::floor(b + 0.5);
        s[k] = a - nearest_a, t[k] = b - nearest_b;
        i[k] = static_cast<std::int32_t>(nearest_a), j[k] = static_cast<std::int32_t>(nearest_b);
      }
    }

    /// End of the points from k on that share the node of point k.
    std::size_t run_end(const std::size_t k, const std::size_t count) const
    {
      std::size_t end = k + 1;
      while (end < count && i[end] == i[k] && j[end] == j[k])
        ++end;
      return end;
    }
  };
} // namespace solid
