// Stencils with the shape as a constant, for the loops over points of scatter.cc and gather.cc.
#pragma once

#include "solid/transfer.h"

namespace solid
{
  /// Replace the stencil's weights by those folded at the lines of `pair`.
  void fold(const Interpolation &, int pair, const Point &x, Stencil &);

  template <Shape shape>
  inline __attribute__((always_inline)) Stencil stencil_of(const Interpolation &at, const double x,
                                                           const double y)
  {
    const Grid &grid = at.grid;
    const std::array<double, 2> &half_size = at.scheme.half_size;
    const double a = (x - grid.lower[0]) * grid.inverse_dx;
    const double b = (y - grid.lower[1]) * grid.inverse_dx;
    const double i = std::floor(a + 0.5), j = std::floor(b + 0.5);
    Stencil s{weights<shape>(a - i, grid.dx, grid.inverse_dx, half_size[0]),
              weights<shape>(b - j, grid.dx, grid.inverse_dx, half_size[1]), static_cast<int>(i),
              static_cast<int>(j)};
    const int pair = grid.fold[grid.at(s.i, s.j)];
    if (__builtin_expect(pair != 0, 0))
      fold(at, pair, {x, y}, s);
    return s;
  }

  // Call f with the shape as a constant, once for many points.
  template <typename F>
  void with_shape(const Shape shape, F &&f)
  {
    switch (shape)
    {
    case Shape::quadratic_bspline:
      return f(std::integral_constant<Shape, Shape::quadratic_bspline>{});
    case Shape::ugimp:
      return f(std::integral_constant<Shape, Shape::ugimp>{});
    case Shape::linear:
      return f(std::integral_constant<Shape, Shape::linear>{});
    }
  }
} // namespace solid
