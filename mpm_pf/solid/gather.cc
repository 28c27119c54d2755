#include "solid/chunk.h"

namespace solid
{
  namespace
  {
    // Part of the old velocity that a point keeps; XPIC has smoothed it already.
    double flip(const Scheme &scheme)
    {
      return scheme.transfer == Transfer::xpic2 ? 1. : scheme.flip_fraction;
    }

    // Sums over the nodes, point by point: {v_x, dv_x/dx, v_y, dv_y/dx}, {dv_x/dy, -, dv_y/dy, -}.
    struct Sums
    {
      alignas(64) double along_x[4 * chunk_points], along_y[4 * chunk_points];
    };

    struct Gathered
    {
      Sums velocity, change; // of velocity by forces, in incremental transfers only
    };

    struct Velocities
    {
      Lanes x, y;
    };

    template <Shape shape>
    inline __attribute__((always_inline)) void sum_run(const Chunk<shape, false> &chunk,
                                                       const Velocity *const field, const Run &run,
                                                       Sums &sums)
    {
      const ChunkWeights &x = chunk.x, &y = chunk.y;
      Quad node[3][3];
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
      {
        const Velocity *const row = field + run.row[b];
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
        {
          const Pair v = load<Pair>(&row[a].x);
          node[b][a] = __builtin_shufflevector(v, v, 0, 0, 1, 1);
        }
      }
      for (std::size_t k = run.begin; k < run.end; ++k)
      {
        const Quad left = x.pair(0, k), middle = x.pair(1, k), right = x.pair(2, k);
        Quad along_x{}, along_y{};
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
        {
          const Quad row = left * node[b][0] + middle * node[b][1] + right * node[b][2];
          along_x += y.pairs[b][2 * k] * row;
          along_y += y.pairs[b][2 * k + 1] * row;
        }
        store(&sums.along_x[4 * k], along_x), store(&sums.along_y[4 * k], along_y);
      }
    }

    // The same for values alone, {v_x, -, v_y, -} in along_x: half the work.
    template <Shape shape>
    inline __attribute__((always_inline)) void sum_values(const Chunk<shape, false> &chunk,
                                                          const Velocity *const field,
                                                          const Run &run, Sums &sums)
    {
      const ChunkWeights &x = chunk.x, &y = chunk.y;
      Pair node[3][3];
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
          node[b][a] = load<Pair>(&field[run.row[b] + a].x);
      for (std::size_t k = run.begin; k < run.end; ++k)
      {
        const double left = x.pairs[0][2 * k], middle = x.pairs[1][2 * k],
                     right = x.pairs[2][2 * k];
        Pair sum{};
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
          sum += y.pairs[b][2 * k] * (left * node[b][0] + middle * node[b][1] + right * node[b][2]);
        store(&sums.along_x[4 * k], Quad{sum[0], 0., sum[1], 0.});
      }
    }

    template <Shape shape, bool slopes>
    void sum_nodes(const Chunk<shape, false> &chunk, const Grid &grid, const Array<Velocity> &field,
                   Sums &sums)
    {
      for (std::size_t k = 0; k < chunk.count;)
      {
        const Run run = chunk.run_from(k, grid);
        if constexpr (slopes)
          sum_run(chunk, field.data(), run, sums);
        else
          sum_values(chunk, field.data(), run, sums);
        k = run.end;
      }
    }

    // Where the gradient goes; returns the velocities of eight points.
    inline __attribute__((always_inline)) Velocities
    put_gradient(const Sums &sums, Points &points, const std::size_t k, const PointRange range)
    {
      const auto put = [&](Array<double> &to, const Lanes &from)
      { store_some(&to[range.begin + k], from, range.size() - k); };
      const FourLanes along_x = load_quads(&sums.along_x[4 * k]);
      const FourLanes along_y = load_quads(&sums.along_y[4 * k]);
      put(points.lxx, along_x.b), put(points.lxy, along_y.a);
      put(points.lyx, along_x.d), put(points.lyy, along_y.c);
      return {along_x.a, along_x.c};
    }

    void give(const Scheme &scheme, const Gathered &from, Points &points, const Moving &moving,
              const PointRange range)
    {
      for (std::size_t k = 0; k < range.size(); k += wide)
      {
        const std::size_t p = range.begin + k, left = range.end - p;
        auto [vx, vy] = put_gradient(from.velocity, points, k, range);
        if (scheme.incremental())
        {
          const double f = flip(scheme);
          const FourLanes by = load_quads(&from.change.along_x[4 * k]);
          store_some(moving.vx + k, vx, left), store_some(moving.vy + k, vy, left);
          vx = f * (load_some(&points.vx[p], left) + by.a) + (1. - f) * vx;
          vy = f * (load_some(&points.vy[p], left) + by.c) + (1. - f) * vy;
        }
        store_some(&points.vx[p], vx, left), store_some(&points.vy[p], vy, left);
      }
    }

    template <Shape shape>
    void gather_points(const Interpolation &at, Points &points, const Moving &moving,
                       const PointRange range)
    {
      const bool incremental = at.scheme.incremental();
      Chunk<shape, false> chunk;
      Gathered sums;
      for (std::size_t first = range.begin; first < range.end; first += chunk_points)
      {
        const PointRange now{first, std::min(first + chunk_points, range.end)};
        chunk.prepare(at, points, now);
        sum_nodes<shape, true>(chunk, at.grid, at.grid.velocity, sums.velocity);
        if (incremental)
          sum_nodes<shape, false>(chunk, at.grid, at.grid.change, sums.change);
        const std::size_t done = incremental ? first - range.begin : 0;
        give(at.scheme, sums, points, {moving.vx + done, moving.vy + done}, now);
      }
    }

    template <Shape shape>
    void gather_slopes(const Interpolation &at, Points &points, const PointRange range)
    {
      Chunk<shape, false> chunk;
      Sums velocity;
      for (std::size_t first = range.begin; first < range.end; first += chunk_points)
      {
        const PointRange now{first, std::min(first + chunk_points, range.end)};
        chunk.prepare(at, points, now);
        sum_nodes<shape, true>(chunk, at.grid, at.grid.velocity, velocity);
        for (std::size_t k = 0; k < now.size(); k += wide)
          put_gradient(velocity, points, k, now);
      }
    }

    template <Shape shape>
    void gather_moments(const Interpolation &at, Points &points, const PointRange range)
    {
      const Grid &grid = at.grid;
      for (std::size_t p = range.begin; p < range.end; ++p)
      {
        const Stencil s = stencil_of<shape>(at, points.x[p], points.y[p]);
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

  void gather(const Interpolation &at, Points &points, const Moving &moving, const PointRange range)
  {
    with_shape(at.scheme.shape, [&](auto shape)
               { gather_points<decltype(shape)::value>(at, points, moving, range); });
  }

  void gather_gradient(const Interpolation &at, Points &points, const PointRange range)
  {
    with_shape(at.scheme.shape,
               [&](auto shape) { gather_slopes<decltype(shape)::value>(at, points, range); });
  }

  void gather_affine(const Interpolation &at, Points &points, const PointRange range)
  {
    with_shape(at.scheme.shape,
               [&](auto shape) { gather_moments<decltype(shape)::value>(at, points, range); });
  }
} // namespace solid
