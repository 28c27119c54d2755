#include "solid/stencil.h"
#include "solid/wide.h"

namespace solid
{
  namespace
  {
    typedef double Pair __attribute__((vector_size(16), may_alias, aligned(16)));

    // Part of the old velocity that a point keeps; XPIC has smoothed it already.
    double flip(const Scheme &scheme)
    {
      return scheme.transfer == Transfer::xpic2 ? 1. : scheme.flip_fraction;
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
    void gather_one(const Scheme &scheme, const FoldTable &table, const Grid &grid, Points &points,
                    Moving &moving, const std::size_t p)
    {
      const double f = flip(scheme);
      const Stencil s = stencil_of<shape>(scheme, grid, table, points.x[p], points.y[p]);
      const Gathered g = sum_nodes(s, grid, grid.velocity.data());
      points.lxx[p] = g.along_x[0], points.lyx[p] = g.along_x[1];
      points.lxy[p] = g.along_y[0], points.lyy[p] = g.along_y[1];
      if (scheme.incremental())
      {
        const Pair change = sum_nodes(s, grid, grid.change.data()).v;
        moving.vx[p] = g.v[0], moving.vy[p] = g.v[1];
        points.vx[p] = f * (points.vx[p] + change[0]) + (1. - f) * g.v[0];
        points.vy[p] = f * (points.vy[p] + change[1]) + (1. - f) * g.v[1];
      }
      else
        points.vx[p] = g.v[0], points.vy[p] = g.v[1];
    }

    // The first `count` of eight values into memory.
    inline __attribute__((always_inline)) void store(Array<double> &to, const std::size_t p,
                                                     const Lanes &from, const std::size_t count)
    {
      if (count == wide)
        std::memcpy(&to[p], &from, sizeof from);
      else
        for (std::size_t q = 0; q < count; ++q)
          to[p + q] = from[q];
    }

    struct WideGathered
    {
      Lanes vx{}, vy{}, lxx{}, lxy{}, lyx{}, lyy{};
    };

    // Sums over the nine nodes around the node of point k, for eight points.
    inline __attribute__((always_inline)) WideGathered
    sum_nodes(const WideWeights &x, const WideWeights &y, const Grid &grid, const Located &at,
              const std::size_t k, const Array<Velocity> &field)
    {
      WideGathered g;
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
      {
        const Velocity *const v = &field[grid.at(at.i[k] - 1, at.j[k] - 1 + b)];
        const Lanes sx = x.w[0] * v[0].x + x.w[1] * v[1].x + x.w[2] * v[2].x;
        const Lanes sy = x.w[0] * v[0].y + x.w[1] * v[1].y + x.w[2] * v[2].y;
        const Lanes gx = x.g[0] * v[0].x + x.g[1] * v[1].x + x.g[2] * v[2].x;
        const Lanes gy = x.g[0] * v[0].y + x.g[1] * v[1].y + x.g[2] * v[2].y;
        g.vx += y.w[b] * sx, g.vy += y.w[b] * sy;
        g.lxx += y.w[b] * gx, g.lyx += y.w[b] * gy;
        g.lxy += y.g[b] * sx, g.lyy += y.g[b] * sy;
      }
      return g;
    }

    // Up to eight points from p on that share the node of point k, which must not be folded.
    template <Shape shape>
    void gather_run(const Scheme &scheme, const Grid &grid, Points &points, Moving &moving,
                    const Located &at, const std::size_t k, const std::size_t p,
                    const std::size_t count)
    {
      const WideWeights x =
          wide_weights<shape>(load(&at.s[k]), grid.dx, grid.inverse_dx, scheme.half_size[0]);
      const WideWeights y =
          wide_weights<shape>(load(&at.t[k]), grid.dx, grid.inverse_dx, scheme.half_size[1]);
      WideGathered g = sum_nodes(x, y, grid, at, k, grid.velocity);
      store(points.lxx, p, g.lxx, count), store(points.lxy, p, g.lxy, count);
      store(points.lyx, p, g.lyx, count), store(points.lyy, p, g.lyy, count);
      if (scheme.incremental())
      {
        const double f = flip(scheme);
        const WideGathered change = sum_nodes(x, y, grid, at, k, grid.change);
        store(moving.vx, p, g.vx, count), store(moving.vy, p, g.vy, count);
        g.vx = f * (load(&points.vx[p]) + change.vx) + (1. - f) * g.vx;
        g.vy = f * (load(&points.vy[p]) + change.vy) + (1. - f) * g.vy;
      }
      store(points.vx, p, g.vx, count), store(points.vy, p, g.vy, count);
    }

    template <Shape shape>
    void gather_points(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points, Moving &moving, const std::size_t begin,
                       const std::size_t end)
    {
      Located at;
      for (std::size_t first = begin; first < end; first += Located::most)
      {
        const std::size_t count = std::min(Located::most, end - first);
        at.locate(grid, points, first, count);
        for (std::size_t k = 0; k < count;)
        {
          const std::size_t stop = at.run_end(k, count);
          const bool folded = grid.fold[grid.at(at.i[k], at.j[k])] != 0;
          while (k < stop)
          {
            const std::size_t n = std::min(stop - k, wide);
            if (!folded && n > 1 && first + k + wide <= points.size())
              gather_run<shape>(scheme, grid, points, moving, at, k, first + k, n);
            else
              for (std::size_t q = k; q < k + n; ++q)
                gather_one<shape>(scheme, table, grid, points, moving, first + q);
            k += n;
          }
        }
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
  } // namespace

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
} // namespace solid
