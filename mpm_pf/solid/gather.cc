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

    struct Velocities
    {
      Lanes x, y;
    };

    // Points [k, end) of the chunk share the nine nodes of which first[b] is the first of a row.
    inline __attribute__((always_inline)) void sum_run(const ChunkWeights &x, const ChunkWeights &y,
                                                       const Velocity *const field,
                                                       const std::array<std::ptrdiff_t, 3> first,
                                                       Sums &sums, std::size_t k,
                                                       const std::size_t end)
    {
      Quad node[3][3];
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
      {
        const Velocity *const row = field + first[b];
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
        {
          const Pair v = load<Pair>(&row[a].x);
          node[b][a] = __builtin_shufflevector(v, v, 0, 0, 1, 1);
        }
      }
      for (; k < end; ++k)
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
    inline __attribute__((always_inline)) void
    sum_values(const ChunkWeights &x, const ChunkWeights &y, const Velocity *const field,
               const std::array<std::ptrdiff_t, 3> first, Sums &sums, std::size_t k,
               const std::size_t end)
    {
      Pair node[3][3];
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
          node[b][a] = load<Pair>(&field[first[b] + a].x);
      for (; k < end; ++k)
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
                   Sums &sums, const std::size_t count)
    {
      for (std::size_t k = 0; k < count;)
      {
        const std::size_t stop = chunk.run_end(k, count);
        const auto rows = rows_around(grid, chunk.i[k], chunk.j[k]);
        if constexpr (slopes)
          sum_run(chunk.x, chunk.y, field.data(), rows, sums, k, stop);
        else
          sum_values(chunk.x, chunk.y, field.data(), rows, sums, k, stop);
        k = stop;
      }
    }

    // Where the gradient goes; returns the velocities of eight points.
    inline __attribute__((always_inline)) Velocities put_gradient(const Sums &sums, Points &points,
                                                                  const std::size_t k,
                                                                  const std::size_t begin,
                                                                  const std::size_t count)
    {
      const auto put = [&](Array<double> &to, const Lanes &from)
      { store_some(&to[begin + k], from, count - k); };
      const FourLanes along_x = load_quads(&sums.along_x[4 * k]);
      const FourLanes along_y = load_quads(&sums.along_y[4 * k]);
      put(points.lxx, along_x.b), put(points.lxy, along_y.a);
      put(points.lyx, along_x.d), put(points.lyy, along_y.c);
      return {along_x.a, along_x.c};
    }

    void give(const Scheme &scheme, const Sums &velocity, const Sums &change, Points &points,
              const Moving &moving, const std::size_t offset, const std::size_t begin,
              const std::size_t count)
    {
      for (std::size_t k = 0; k < count; k += wide)
      {
        const auto put = [&](Array<double> &to, const Lanes &from)
        { store_some(&to[begin + k], from, count - k); };
        auto [vx, vy] = put_gradient(velocity, points, k, begin, count);
        if (scheme.incremental())
        {
          const double f = flip(scheme);
          const FourLanes by = load_quads(&change.along_x[4 * k]);
          store_some(moving.vx + offset + k, vx, count - k);
          store_some(moving.vy + offset + k, vy, count - k);
          vx = f * (load_some(&points.vx[begin + k], count - k) + by.a) + (1. - f) * vx;
          vy = f * (load_some(&points.vy[begin + k], count - k) + by.c) + (1. - f) * vy;
        }
        put(points.vx, vx), put(points.vy, vy);
      }
    }

    template <Shape shape>
    void gather_points(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points, const Moving &moving, const std::size_t begin,
                       const std::size_t end)
    {
      Chunk<shape, false> chunk;
      Sums velocity, change;
      for (std::size_t first = begin; first < end; first += chunk_points)
      {
        const std::size_t count = std::min(chunk_points, end - first);
        chunk.prepare(scheme, grid, table, points, first, count);
        sum_nodes<shape, true>(chunk, grid, grid.velocity, velocity, count);
        if (scheme.incremental())
          sum_nodes<shape, false>(chunk, grid, grid.change, change, count);
        give(scheme, velocity, change, points, moving, first - begin, first, count);
      }
    }

    template <Shape shape>
    void gather_slopes(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points, const std::size_t begin, const std::size_t end)
    {
      Chunk<shape, false> chunk;
      Sums velocity;
      for (std::size_t first = begin; first < end; first += chunk_points)
      {
        const std::size_t count = std::min(chunk_points, end - first);
        chunk.prepare(scheme, grid, table, points, first, count);
        sum_nodes<shape, true>(chunk, grid, grid.velocity, velocity, count);
        for (std::size_t k = 0; k < count; k += wide)
          put_gradient(velocity, points, k, first, count);
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
              const Moving &moving, const std::size_t begin, const std::size_t end)
  {
    with_shape(scheme.shape,
               [&](auto shape) {
                 gather_points<decltype(shape)::value>(scheme, table, grid, points, moving, begin,
                                                       end);
               });
  }

  void gather_gradient(const Scheme &scheme, const FoldTable &table, const Grid &grid,
                       Points &points, const std::size_t begin, const std::size_t end)
  {
    with_shape(scheme.shape, [&](auto shape)
               { gather_slopes<decltype(shape)::value>(scheme, table, grid, points, begin, end); });
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
