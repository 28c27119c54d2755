#include "solid/mirrors.h"
#include "solid/stencil.h"

namespace solid
{
  // Folding is rare, so it stays out of the loops' way, in a file of its own.
  void fold(const Interpolation &at, const int pair, const Point &x, Stencil &s)
  {
    const Grid &grid = at.grid;
    const FoldTable &table = at.folds;
    const auto &[across_x, across_y] = table.pairs[pair - 1];
    if (across_x >= 0)
      apply(table.lines[across_x], s.i, x[0], grid.lower[0], grid.dx, s.x);
    if (across_y >= 0)
      apply(table.lines[across_y], s.j, x[1], grid.lower[1], grid.dx, s.y);
  }

  Stencil stencil(const Interpolation &at, const Point &x)
  {
    Stencil s{};
    with_shape(at.scheme.shape,
               [&](auto shape) { s = stencil_of<decltype(shape)::value>(at, x[0], x[1]); });
    return s;
  }

  void smooth_velocity(const Interpolation &at, Points &points)
  {
    const Grid &grid = at.grid;
    // v* lies in the nodes' momenta; S v* goes to the nodes again, with the points' masses.
    std::vector<Point> again(grid.nodes.size(), Point::Zero()), once(points.active);
    const auto each = [&](const std::size_t p, auto &&f)
    {
      const Stencil s = stencil(at, {points.x[p], points.y[p]});
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
          f(image_of(grid, s.i - 1 + a, s.j - 1 + b), s.x.w[a] * s.y.w[b]);
    };
    for (std::size_t p = 0; p < points.active; ++p)
    {
      Point v = Point::Zero();
      each(p,
           [&](const Image &image, const double w)
           {
             if (const double mass = grid.mass[image.node]; mass > 0.)
               v += image.apply(w * grid.nodes[image.node].momentum() / mass);
           });
      once[p] = v;
      each(p, [&](const Image &image, const double w)
           { again[image.node] += image.apply(w * points.mass[p] * v); });
    }
    for (std::size_t p = 0; p < points.active; ++p)
    {
      Point twice = Point::Zero();
      each(p,
           [&](const Image &image, const double w)
           {
             if (const double mass = grid.mass[image.node]; mass > 0.)
               twice += image.apply(w * again[image.node] / mass);
           });
      points.vx[p] = 2. * once[p][0] - twice[0], points.vy[p] = 2. * once[p][1] - twice[1];
    }
  }
} // namespace solid
