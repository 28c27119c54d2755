#include "solid/constitutive.h"

namespace solid
{
  namespace
  {
    constexpr std::size_t chunk = 64; // points whose cell values are looked up before computing

    struct CellValues
    {
      double mean[chunk];
      std::ptrdiff_t cell[chunk];
    };

    template <bool plastic, bool averaged>
    double update_chunk(Points &points, const Step &step, const CellValues &cells,
                        const std::size_t begin, const std::size_t count)
    {
      double *const sxx = &points.sxx[begin], *const syy = &points.syy[begin];
      double *const szz = &points.szz[begin], *const sxy = &points.sxy[begin];
      double *const strain = &points.plastic[begin], *const jacobian = &points.jacobian[begin];
      const double *const lxx = &points.lxx[begin], *const lxy = &points.lxy[begin];
      const double *const lyx = &points.lyx[begin], *const lyy = &points.lyy[begin];
      const double *const mass = &points.mass[begin];
      double dissipated = 0.;
#pragma omp simd reduction(+ : dissipated)
      for (std::size_t k = 0; k < count; ++k)
      {
        const Increment e = increment(lxx[k], lxy[k], lyx[k], lyy[k], step.dt);
        const double volumetric = averaged ? cells.mean[k] : e.xx + e.yy;
        const Updated now =
            update<plastic>({sxx[k], syy[k], szz[k], sxy[k]}, e, volumetric, step.flow);
        sxx[k] = now.stress.xx, syy[k] = now.stress.yy;
        szz[k] = now.stress.zz, sxy[k] = now.stress.xy;
        // exp() of the volume strain to third order: a stretch and its reversal cancel.
        jacobian[k] *= 1. + volumetric * (1. + volumetric * (0.5 + volumetric * (1. / 6.)));
        if constexpr (plastic)
        {
          strain[k] += now.plastic;
          dissipated += mass[k] * step.inverse_density * jacobian[k] * now.dissipated;
        }
      }
      return dissipated;
    }

    void look_up(const Points &points, const Grid &grid, const CellMeans &means, CellValues &cells,
                 const std::size_t begin, const std::size_t count)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        cells.cell[k] = cell_index(grid, points.x[begin + k], points.y[begin + k]);
        cells.mean[k] = means.rate[cells.cell[k]].mean(0.);
      }
    }

    void collect_pressure(const Points &points, const double inverse_density, CellMeans &means,
                          const CellValues &cells, const std::size_t begin, const std::size_t count)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        const std::size_t p = begin + k;
        const double volume = points.mass[p] * inverse_density * points.jacobian[p];
        CellSum &sum = means.pressure[cells.cell[k]];
        sum.volume += volume;
        sum.value -= volume * (points.sxx[p] + points.syy[p] + points.szz[p]) * (1. / 3.);
      }
    }

    template <bool plastic>
    void update_range(Points &points, const Grid &grid, const Step &step, CellMeans *means,
                      Share &share, const std::size_t begin, const std::size_t end)
    {
      CellValues cells;
      for (std::size_t p = begin; p < end; p += chunk)
      {
        const std::size_t count = std::min(chunk, end - p);
        if (means)
        {
          look_up(points, grid, *means, cells, p, count);
          share.dissipated += update_chunk<plastic, true>(points, step, cells, p, count);
          collect_pressure(points, step.inverse_density, *means, cells, p, count);
        }
        else
          share.dissipated += update_chunk<plastic, false>(points, step, cells, p, count);
      }
    }

    void relax(Points &points, const Grid &grid, const Step &step, const CellMeans &means,
               const std::size_t begin, const std::size_t end)
    {
      for (std::size_t p = begin; p < end; ++p)
      {
        const double here = -(points.sxx[p] + points.syy[p] + points.szz[p]) * (1. / 3.);
        const CellSum &sum = means.pressure[cell_index(grid, points.x[p], points.y[p])];
        const double change = step.relaxation * (sum.mean(here) - here);
        points.sxx[p] -= change, points.syy[p] -= change, points.szz[p] -= change;
      }
    }
  } // namespace

  void collect_rates(const Points &points, const Grid &grid, const Step &step, CellMeans &means,
                     const std::size_t begin, const std::size_t end)
  {
    for (std::size_t p = begin; p < end; ++p)
    {
      const Increment e =
          increment(points.lxx[p], points.lxy[p], points.lyx[p], points.lyy[p], step.dt);
      const double volume = points.mass[p] * step.inverse_density * points.jacobian[p];
      CellSum &sum = means.rate[cell_index(grid, points.x[p], points.y[p])];
      sum.volume += volume;
      sum.value += volume * (e.xx + e.yy);
    }
  }

  void update_stress(Points &points, const Grid &grid, const Step &step, CellMeans *means,
                     Share &share, const std::size_t begin, const std::size_t end)
  {
    if (step.plastic)
      update_range<true>(points, grid, step, means, share, begin, end);
    else
      update_range<false>(points, grid, step, means, share, begin, end);
  }

  void move(Points &points, const Moving &moving, const Grid &grid, const Step &step,
            const CellMeans *means, Share &share, const std::size_t begin, const std::size_t end)
  {
    if (means)
      relax(points, grid, step, *means, begin, end);
    const double *const vx = moving.vx.empty() ? points.vx.data() : moving.vx.data();
    const double *const vy = moving.vy.empty() ? points.vy.data() : moving.vy.data();
    double kinetic = 0., largest = share.largest_speed2;
    long wrong = 0;
#pragma omp simd reduction(+ : kinetic, wrong) reduction(max : largest)
    for (std::size_t p = begin; p < end; ++p)
    {
      const double speed2 = points.vx[p] * points.vx[p] + points.vy[p] * points.vy[p];
      const double x = points.x[p] + step.dt * vx[p], y = points.y[p] + step.dt * vy[p];
      kinetic += 0.5 * points.mass[p] * speed2;
      largest = largest > speed2 ? largest : speed2;
      // Written so that a value which is not a number counts as wrong.
      const bool right = (speed2 < step.speed_limit2) & (points.jacobian[p] > 0.) &
                         ((points.sxx[p] - points.sxx[p]) + (points.syy[p] - points.syy[p]) == 0.) &
                         (x >= step.lower[0]) & (x <= step.upper[0]) & (y >= step.lower[1]) &
                         (y <= step.upper[1]);
      wrong += right ? 0 : 1;
      points.x[p] = x, points.y[p] = y;
    }
    share.kinetic += kinetic;
    share.largest_speed2 = largest;
    for (std::size_t p = begin; wrong > 0 && share.bad < 0 && p < end; ++p)
      if (!(points.vx[p] * points.vx[p] + points.vy[p] * points.vy[p] < step.speed_limit2) ||
          !(points.jacobian[p] > 0.) || !std::isfinite(points.sxx[p] + points.syy[p]) ||
          !(points.x[p] >= step.lower[0] && points.x[p] <= step.upper[0]) ||
          !(points.y[p] >= step.lower[1] && points.y[p] <= step.upper[1]))
        share.bad = static_cast<std::ptrdiff_t>(p);
  }
} // namespace solid
