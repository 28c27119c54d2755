#include "solid/stencil.h"
#include "solid/wide.h"

namespace solid
{
  namespace
  {
    // One point by itself: where shape functions are folded, and what a run leaves over.
    template <Shape shape, bool affine>
    void scatter_one(const Scheme &scheme, const FoldTable &table, const Points &points,
                     const Acceleration &force, const double inverse_density, Grid &grid,
                     const std::size_t p)
    {
      const Stencil s = stencil_of<shape>(scheme, grid, table, points.x[p], points.y[p]);
      const bool uniform = force.x.empty();
      const double m = points.mass[p], volume = m * inverse_density * points.jacobian[p];
      const double bx = uniform ? force.uniform[0] : force.x[p];
      const double by = uniform ? force.uniform[1] : force.y[p];
      const double fxx = -volume * points.sxx[p], fxy = -volume * points.sxy[p];
      const double fyy = -volume * points.syy[p];
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
        {
          const double w = s.x.w[a] * s.y.w[b], mw = m * w;
          const double gx = s.x.g[a] * s.y.w[b], gy = s.x.w[a] * s.y.g[b];
          double vx = points.vx[p], vy = points.vy[p];
          if constexpr (affine)
          {
            vx += points.lxx[p] * s.x.d[a] + points.lxy[p] * s.y.d[b];
            vy += points.lyx[p] * s.x.d[a] + points.lyy[p] * s.y.d[b];
          }
          // - V sigma grad w + w m b, Eq. (4)
          grid.nodes[grid.at(s.i - 1 + a, s.j - 1 + b)].lanes += Lanes{
              mw, mw * vx, mw * vy, fxx * gx + fxy * gy + mw * bx, fxy * gx + fyy * gy + mw * by,
              0., 0.,      0.};
        }
    }

    // Up to eight points from p on that share the node (i, j), which must not be folded.
    template <Shape shape, bool affine>
    inline __attribute__((always_inline)) void
    scatter_run(const Scheme &scheme, const Points &points, const Acceleration &force,
                const double inverse_density, Grid &grid, const Located &at, const std::size_t k,
                const std::size_t p, const std::size_t count)
    {
      const WideWeights x =
          wide_weights<shape>(load(&at.s[k]), grid.dx, grid.inverse_dx, scheme.half_size[0]);
      const WideWeights y =
          wide_weights<shape>(load(&at.t[k]), grid.dx, grid.inverse_dx, scheme.half_size[1]);
      const Lanes none{}, number{0., 1., 2., 3., 4., 5., 6., 7.};
      const Lanes m = number < none + static_cast<double>(count) ? load(&points.mass[p]) : none;
      const Lanes volume = m * inverse_density * load(&points.jacobian[p]);
      const Lanes fxx = -volume * load(&points.sxx[p]), fxy = -volume * load(&points.sxy[p]);
      const Lanes fyy = -volume * load(&points.syy[p]);
      const Lanes px = m * load(&points.vx[p]), py = m * load(&points.vy[p]);
      Lanes pxx = none, pxy = none, pyx = none, pyy = none;
      if constexpr (affine)
      {
        pxx = m * load(&points.lxx[p]), pxy = m * load(&points.lxy[p]);
        pyx = m * load(&points.lyx[p]), pyy = m * load(&points.lyy[p]);
      }
      const bool uniform = force.x.empty();
      const Lanes bx = m * (uniform ? none + force.uniform[0] : load(&force.x[p]));
      const Lanes by = m * (uniform ? none + force.uniform[1] : load(&force.y[p]));
      const std::ptrdiff_t row[3] = {grid.at(at.i[k] - 1, at.j[k] - 1),
                                     grid.at(at.i[k] - 1, at.j[k]),
                                     grid.at(at.i[k] - 1, at.j[k] + 1)};
#pragma GCC unroll 3
      for (int a = 0; a < 3; ++a)
      {
        const Lanes w = x.w[a], g = x.g[a], wm = w * m;
        const Lanes wpx = w * (px + x.d[a] * pxx), wpy = w * (py + x.d[a] * pyx);
        const Lanes wxy = w * pxy, wyy = w * pyy;
        const Lanes gx = g * fxx + w * bx, gy = g * fxy + w * by; // Eq. (4)
        const Lanes hx = w * fxy, hy = w * fyy;
#pragma GCC unroll 3
        for (int b = 0; b < 3; ++b)
        {
          const Lanes wb = y.w[b], gb = y.g[b], db = wb * y.d[b];
          grid.nodes[row[b] + a].lanes += sums(wb * wm, wb * wpx + db * wxy, wb * wpy + db * wyy,
                                               wb * gx + gb * hx, wb * gy + gb * hy);
        }
      }
    }

    template <Shape shape, bool affine>
    void scatter_points(const Scheme &scheme, const FoldTable &table, const Points &points,
                        const Acceleration &force, const double inverse_density, Grid &grid,
                        const std::size_t begin, const std::size_t end)
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
            if (!folded && n > 2 && first + k + wide <= points.size())
              scatter_run<shape, affine>(scheme, points, force, inverse_density, grid, at, k,
                                         first + k, n);
            else
              for (std::size_t q = k; q < k + n; ++q)
                scatter_one<shape, affine>(scheme, table, points, force, inverse_density, grid,
                                           first + q);
            k += n;
          }
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
