#include "solid/chunk.h"

namespace solid
{
  namespace
  {
    // Four numbers a point in the order of a node, {p_x, f_x, p_y, f_y}. The node (a, b) gets
    //   w_a w_b plain + {w_a d_a, g_a} w_b along_x + w_a {w_b d_b, g_b} along_y
    // and the mass m w_a w_b, kept as m w_a in one vector for the three columns a.
    struct Carried
    {
      alignas(64) double plain[4 * chunk_points], along_x[4 * chunk_points];
      alignas(64) double along_y[4 * chunk_points], mass[4 * chunk_points];
    };

    template <bool affine>
    void fill(Carried &to, const Points &points, const Acceleration &force,
              const double inverse_density, const ChunkWeights &x, const std::size_t begin,
              const std::size_t count)
    {
      const bool uniform = force.x.empty();
      for (std::size_t k = 0; k < count; k += wide)
      {
        const auto values = [&](const Array<double> &array)
        { return load_some(&array[begin + k], count - k); };
        const Lanes none{}, m = values(points.mass);
        const Lanes volume = m * inverse_density * values(points.jacobian);
        // - V sigma grad w + w m b, Eq. (4)
        const Lanes fxx = -volume * values(points.sxx), fyy = -volume * values(points.syy);
        const Lanes fxy = -volume * values(points.sxy);
        const Lanes bx = uniform ? none + force.uniform[0] : values(force.x);
        const Lanes by = uniform ? none + force.uniform[1] : values(force.y);
        Lanes pxx = none, pxy = none, pyx = none, pyy = none;
        if constexpr (affine)
        {
          pxx = m * values(points.lxx), pxy = m * values(points.lxy);
          pyx = m * values(points.lyx), pyy = m * values(points.lyy);
        }
        store_quads(&to.plain[4 * k], m * values(points.vx), m * bx, m * values(points.vy), m * by);
        store_quads(&to.along_x[4 * k], pxx, fxx, pyx, fxy);
        store_quads(&to.along_y[4 * k], pxy, fxy, pyy, fyy);
        store_quads(&to.mass[4 * k], m * load<Lanes>(&x.w[0][k]), m * load<Lanes>(&x.w[1][k]),
                    m * load<Lanes>(&x.w[2][k]), none);
      }
    }

    // Points [k, end) of the chunk share the nine nodes of which row[b] is the first of a row.
    inline __attribute__((always_inline)) void add_run(const ChunkWeights &x, const ChunkWeights &y,
                                                       const Carried &from, Node *const nodes,
                                                       double *const node_mass,
                                                       const std::array<std::ptrdiff_t, 3> row,
                                                       std::size_t k, const std::size_t end)
    {
      Quad sum[3][3] = {}, mass[3] = {};
      for (; k < end; ++k)
      {
        const Quad plain = load<Quad>(&from.plain[4 * k]), m = load<Quad>(&from.mass[4 * k]);
        const Quad along_x = load<Quad>(&from.along_x[4 * k]);
        const Quad along_y = load<Quad>(&from.along_y[4 * k]);
        Quad left[3], right[3];
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
        {
          left[a] = x.weight(a, k) * plain + x.pair(a, k) * along_x;
          right[a] = x.weight(a, k) * along_y;
        }
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
        {
          const double w = y.weight(b, k);
          const Quad pair = y.pair(b, k);
          mass[b] += w * m;
#pragma GCC unroll 3
          for (int a = 0; a < 3; ++a)
            sum[b][a] += w * left[a], sum[b][a] += pair * right[a];
        }
      }
#pragma GCC unroll 3
      for (int b = 0; b < 3; ++b)
      {
        // The fourth column gets nothing; every row has room for it (grid.cc).
        store<Quad>(node_mass + row[b], load<Quad>(node_mass + row[b]) + mass[b]);
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
          nodes[row[b] + a].motion += sum[b][a];
      }
    }

    template <Shape shape, bool affine>
    void scatter_points(const Scheme &scheme, const FoldTable &table, const Points &points,
                        const Acceleration &force, const double inverse_density, Grid &grid,
                        const std::size_t begin, const std::size_t end)
    {
      Chunk<shape, true> chunk;
      Carried carried;
      for (std::size_t first = begin; first < end; first += chunk_points)
      {
        const std::size_t count = std::min(chunk_points, end - first);
        chunk.prepare(scheme, grid, table, points, first, count);
        fill<affine>(carried, points, force, inverse_density, chunk.x, first, count);
        for (std::size_t k = 0; k < count;)
        {
          const std::size_t stop = chunk.run_end(k, count);
          add_run(chunk.x, chunk.y, carried, grid.nodes.data(), grid.mass.data(),
                  rows_around(grid, chunk.i[k], chunk.j[k]), k, stop);
          k = stop;
        }
      }
    }
  } // namespace

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
} // namespace solid
