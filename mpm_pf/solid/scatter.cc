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
    void fill(Carried &to, const MomentumSource &source, const ChunkWeights &x,
              const PointRange range)
    {
      const Points &points = source.points;
      const Acceleration &force = source.acceleration;
      const double inverse_density = source.inverse_density;
      const bool uniform = force.x.empty();
      for (std::size_t k = 0; k < range.size(); k += wide)
      {
        const auto values = [&](const Array<double> &array)
        { return load_some(&array[range.begin + k], range.size() - k); };
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

    template <Shape shape>
    inline __attribute__((always_inline)) void
    add_run(const Chunk<shape, true> &chunk, const Carried &from, const Run &run, Grid &grid)
    {
      const ChunkWeights &x = chunk.x, &y = chunk.y;
      Node *const nodes = grid.nodes.data();
      double *const node_mass = grid.mass.data();
      Quad sum[3][3] = {}, mass[3] = {};
      for (std::size_t k = run.begin; k < run.end; ++k)
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
        store<Quad>(node_mass + run.row[b], load<Quad>(node_mass + run.row[b]) + mass[b]);
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a)
          nodes[run.row[b] + a].motion += sum[b][a];
      }
    }

    template <Shape shape, bool affine>
    void scatter_points(const Interpolation &at, const MomentumSource &source, Grid &grid,
                        const PointRange range)
    {
      Chunk<shape, true> chunk;
      Carried carried;
      for (std::size_t first = range.begin; first < range.end; first += chunk_points)
      {
        const PointRange now{first, std::min(first + chunk_points, range.end)};
        chunk.prepare(at, source.points, now);
        fill<affine>(carried, source, chunk.x, now);
        for (std::size_t k = 0; k < chunk.count;)
        {
          const Run run = chunk.run_from(k, grid);
          add_run(chunk, carried, run, grid);
          k = run.end;
        }
      }
    }
  } // namespace

  void scatter(const Interpolation &at, const MomentumSource &source, Grid &grid,
               const PointRange range)
  {
    with_shape(at.scheme.shape,
               [&](auto shape)
               {
                 constexpr Shape S = decltype(shape)::value;
                 if (at.scheme.affine())
                   scatter_points<S, true>(at, source, grid, range);
                 else
                   scatter_points<S, false>(at, source, grid, range);
               });
  }
} // namespace solid
