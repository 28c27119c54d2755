#include "solid/transfer.h"

#include <limits>

namespace solid
{
  namespace
  {
    typedef double Pair __attribute__((vector_size(16), may_alias, aligned(16)));

    // Folding is rare, so it stays out of the loops' way.
    __attribute__((noinline)) void fold(const FoldTable &table, const Grid &grid, const int pair,
                                        const Point &x, Stencil &s)
    {
      const auto &[across_x, across_y] = table.pairs[pair - 1];
      if (across_x >= 0)
        apply(table.lines[across_x], s.i, x[0], grid.lower[0], grid.dx, s.x);
      if (across_y >= 0)
        apply(table.lines[across_y], s.j, x[1], grid.lower[1], grid.dx, s.y);
    }

    template <Shape shape>
    inline __attribute__((always_inline)) Stencil stencil_of(const Scheme &scheme, const Grid &grid,
                                                             const FoldTable &table, const double x,
                                                             const double y)
    {
      const double a = (x - grid.lower[0]) * grid.inverse_dx;
      const double b = (y - grid.lower[1]) * grid.inverse_dx;
      const double i = std::floor(a + 0.5), j = std::floor(b + 0.5);
      Stencil s{weights<shape>(a - i, grid.dx, grid.inverse_dx, scheme.half_size[0]),
                weights<shape>(b - j, grid.dx, grid.inverse_dx, scheme.half_size[1]),
                static_cast<int>(i), static_cast<int>(j)};
      const int pair = grid.fold[grid.at(s.i, s.j)];
      if (__builtin_expect(pair != 0, 0))
        fold(table, grid, pair, {x, y}, s);
      return s;
    }

    template <Shape shape, bool affine>
    void scatter_points(const Scheme &scheme, const FoldTable &table, const Points &points,
                        const Acceleration &force, const double inverse_density, Grid &grid,
                        const std::size_t begin, const std::size_t end)
    {
      Lanes sum[9] = {};
      std::ptrdiff_t at[3] = {0, 0, 0};
      int i = std::numeric_limits<int>::min(), j = i;
      // Points of one node follow each other: its nine neighbours stay in registers meanwhile.
      const auto flush = [&]
      {
        if (i == std::numeric_limits<int>::min())
          return;
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
#pragma GCC unroll 3
          for (int a = 0; a < 3; ++a)
            grid.nodes[at[b] + a].lanes += sum[3 * b + a], sum[3 * b + a] = Lanes{};
      };
      const bool uniform = force.x.empty();
      for (std::size_t p = begin; p < end; ++p)
      {
        const Stencil s = stencil_of<shape>(scheme, grid, table, points.x[p], points.y[p]);
        if (s.i != i || s.j != j)
        {
          flush();
          i = s.i, j = s.j;
          for (int b = 0; b < 3; ++b)
            at[b] = grid.at(i - 1, j - 1 + b);
        }
        const double m = points.mass[p], volume = m * inverse_density * points.jacobian[p];
        const double bx = uniform ? force.uniform[0] : force.x[p];
        const double by = uniform ? force.uniform[1] : force.y[p];
        const double fxx = -volume * points.sxx[p], fxy = -volume * points.sxy[p];
        const double fyy = -volume * points.syy[p];
        const Lanes body = {m, m * points.vx[p], m * points.vy[p], m * bx, m * by, 0., 0., 0.};
        const Lanes along_x = {0., 0., 0., fxx, fxy, 0., 0., 0.}; // - V sigma grad w, Eq. (4)
        const Lanes along_y = {0., 0., 0., fxy, fyy, 0., 0., 0.};
        Lanes shear_x = {}, shear_y = {};
        if constexpr (affine)
        {
          shear_x = Lanes{0., m * points.lxx[p], m * points.lyx[p], 0., 0., 0., 0., 0.};
          shear_y = Lanes{0., m * points.lxy[p], m * points.lyy[p], 0., 0., 0., 0., 0.};
        }
        Lanes column[3], row[3];
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
          column[a] = s.x.w[a] * (body + s.x.d[a] * shear_x) + s.x.g[a] * along_x;
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
          row[b] = (s.y.w[b] * s.y.d[b]) * shear_y + s.y.g[b] * along_y;
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
#pragma GCC unroll 3
          for (int a = 0; a < 3; ++a)
            sum[3 * b + a] += s.y.w[b] * column[a] + s.x.w[a] * row[b];
      }
      flush();
    }

    struct Gathered
    {
      Pair v, along_x, along_y; // value and its derivatives
    };

    inline __attribute__((always_inline)) Gathered sum_nodes(const Stencil &s, const Grid &grid,
                                                             const Velocity *field)
    {
      Gathered g{};
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
      {
        const auto *row = reinterpret_cast<const Pair *>(field + grid.at(s.i - 1, s.j - 1 + b));
        const Pair value = s.x.w[0] * row[0] + s.x.w[1] * row[1] + s.x.w[2] * row[2];
        const Pair slope = s.x.g[0] * row[0] + s.x.g[1] * row[1] + s.x.g[2] * row[2];
        g.v += s.y.w[b] * value;
        g.along_x += s.y.w[b] * slope;
        g.along_y += s.y.g[b] * value;
      }
      return g;
    }

    template <Shape shape>
    void gather_points(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points, Moving &moving, const std::size_t begin,
                       const std::size_t end)
    {
      const bool incremental = scheme.incremental();
      const double f = scheme.transfer == Transfer::xpic2 ? 1. : scheme.flip_fraction;
      for (std::size_t p = begin; p < end; ++p)
      {
        const Stencil s = stencil_of<shape>(scheme, grid, table, points.x[p], points.y[p]);
        const Gathered g = sum_nodes(s, grid, grid.velocity.data());
        points.lxx[p] = g.along_x[0], points.lyx[p] = g.along_x[1];
        points.lxy[p] = g.along_y[0], points.lyy[p] = g.along_y[1];
        if (incremental)
        {
          const Pair change = sum_nodes(s, grid, grid.change.data()).v;
          moving.vx[p] = g.v[0], moving.vy[p] = g.v[1];
          points.vx[p] = f * (points.vx[p] + change[0]) + (1. - f) * g.v[0];
          points.vy[p] = f * (points.vy[p] + change[1]) + (1. - f) * g.v[1];
        }
        else
          points.vx[p] = g.v[0], points.vy[p] = g.v[1];
      }
    }

    template <Shape shape>
    void gather_moments(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                        Points &points, const std::size_t begin, const std::size_t end)
    {
      for (std::size_t p = begin; p < end; ++p)
      {
        const Stencil s = stencil_of<shape>(scheme, grid, table, points.x[p], points.y[p]);
        Pair mx{}, my{};
        double dx2 = 0., dy2 = 0.;
        for (int k = 0; k < 3; ++k)
          dx2 += s.x.w[k] * s.x.d[k] * s.x.d[k], dy2 += s.y.w[k] * s.y.d[k] * s.y.d[k];
        for (int b = 0; b < 3; ++b)
          for (int a = 0; a < 3; ++a)
          {
            const Velocity &v = grid.velocity[grid.at(s.i - 1 + a, s.j - 1 + b)];
            const double w = s.x.w[a] * s.y.w[b];
            mx += w * s.x.d[a] * Pair{v.x, v.y}, my += w * s.y.d[b] * Pair{v.x, v.y};
          }
        // On a held line, or a node of linear functions, the second moment vanishes; there the
        // velocity gradient, already in place, is the limit.
        const double least = 1e-6 * grid.dx * grid.dx;
        if (dx2 > least)
          points.lxx[p] = mx[0] / dx2, points.lyx[p] = mx[1] / dx2;
        if (dy2 > least)
          points.lxy[p] = my[0] / dy2, points.lyy[p] = my[1] / dy2;
      }
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
  } // namespace

  Stencil stencil(const Scheme &scheme, const Grid &grid, const FoldTable &table, const Point &x)
  {
    Stencil s{};
    with_shape(scheme.shape, [&](auto shape)
               { s = stencil_of<decltype(shape)::value>(scheme, grid, table, x[0], x[1]); });
    return s;
  }

  void scatter(const Scheme &scheme, const FoldTable &table, const Points &points,
               const Acceleration &force, const double inverse_density, Grid &grid,
               const std::size_t begin, const std::size_t end)
  {
    with_shape(scheme.shape,
               [&](auto shape)
               {
                 constexpr Shape S = decltype(shape)::value;
                 if (scheme.affine())
                   scatter_points<S, true>(scheme, table, points, force, inverse_density, grid,
                                           begin, end);
                 else
                   scatter_points<S, false>(scheme, table, points, force, inverse_density, grid,
                                            begin, end);
               });
  }

  void gather(const Scheme &scheme, const FoldTable &table, const Grid &grid, Points &points,
              Moving &moving, const std::size_t begin, const std::size_t end)
  {
    with_shape(scheme.shape,
               [&](auto shape) {
                 gather_points<decltype(shape)::value>(scheme, table, grid, points, moving, begin,
                                                       end);
               });
  }

  void gather_affine(const Scheme &scheme, const FoldTable &table, const Grid &grid, Points &points,
                     const std::size_t begin, const std::size_t end)
  {
    with_shape(scheme.shape,
               [&](auto shape) {
                 gather_moments<decltype(shape)::value>(scheme, table, grid, points, begin, end);
               });
  }

  void smooth_velocity(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points)
  {
    // v* lies in the nodes' momenta; S v* goes to the nodes again, with the points' masses.
    std::vector<Point> again(grid.nodes.size(), Point::Zero()), once(points.active);
    const auto each = [&](const std::size_t p, auto &&f)
    {
      const Stencil s = stencil(scheme, grid, table, {points.x[p], points.y[p]});
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
          f(grid.at(s.i - 1 + a, s.j - 1 + b), s.x.w[a] * s.y.w[b]);
    };
    for (std::size_t p = 0; p < points.active; ++p)
    {
      Point v = Point::Zero();
      each(p,
           [&](const std::ptrdiff_t n, const double w)
           {
             v += grid.nodes[n].mass() > 0.
                      ? Point(w * grid.nodes[n].momentum() / grid.nodes[n].mass())
                      : Point(0., 0.);
           });
      once[p] = v;
      each(p, [&](const std::ptrdiff_t n, const double w) { again[n] += w * points.mass[p] * v; });
    }
    for (std::size_t p = 0; p < points.active; ++p)
    {
      Point twice = Point::Zero();
      each(p,
           [&](const std::ptrdiff_t n, const double w)
           {
             twice += grid.nodes[n].mass() > 0. ? Point(w * again[n] / grid.nodes[n].mass())
                                                : Point(0., 0.);
           });
      points.vx[p] = 2. * once[p][0] - twice[0], points.vy[p] = 2. * once[p][1] - twice[1];
    }
  }
} // namespace solid
