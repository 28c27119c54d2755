#include "solid/constitutive.h"

namespace solid
{
  namespace
  {
    // Points whose values are computed side by side before the cells are touched one by one.
    constexpr std::size_t chunk = 64;

    struct Chunk
    {
      double volume[chunk], value[chunk];
      std::int32_t i[chunk], j[chunk];
    };

    void strain_rates(const Points &points, const Grid &grid, const Step &step, Chunk &now,
                      const std::size_t begin, const std::size_t count)
    {
      const double *const x = &points.x[begin], *const y = &points.y[begin];
      const double *const lxx = &points.lxx[begin], *const lxy = &points.lxy[begin];
      const double *const lyx = &points.lyx[begin], *const lyy = &points.lyy[begin];
      const double *const mass = &points.mass[begin], *const jacobian = &points.jacobian[begin];
      const double x0 = grid.lower[0], y0 = grid.lower[1], scale = grid.inverse_dx;
      const double inverse_density = step.inverse_density, dt = step.dt;
#pragma omp simd
      for (std::size_t k = 0; k < count; ++k)
      {
        const Increment e = increment(lxx[k], lxy[k], lyx[k], lyy[k], dt);
        now.volume[k] = mass[k] * inverse_density * jacobian[k];
        now.value[k] = now.volume[k] * (e.xx + e.yy);
        now.i[k] = static_cast<std::int32_t>(std::floor((x[k] - x0) * scale));
        now.j[k] = static_cast<std::int32_t>(std::floor((y[k] - y0) * scale));
      }
    }

    template <bool plastic, bool averaged>
    double update_chunk(Points &points, const Step &step, Chunk &now, const std::size_t begin,
                        const std::size_t count)
    {
      double *const sxx = &points.sxx[begin], *const syy = &points.syy[begin];
      double *const szz = &points.szz[begin], *const sxy = &points.sxy[begin];
      double *const strain = &points.plastic[begin], *const jacobian = &points.jacobian[begin];
      const double *const lxx = &points.lxx[begin], *const lxy = &points.lxy[begin];
      const double *const lyx = &points.lyx[begin], *const lyy = &points.lyy[begin];
      const double *const mass = &points.mass[begin];
      const Flow flow = step.flow;
      const double dt = step.dt, inverse_density = step.inverse_density;
      double dissipated = 0.;
#pragma omp simd reduction(+ : dissipated)
      for (std::size_t k = 0; k < count; ++k)
      {
        const Increment e = increment(lxx[k], lxy[k], lyx[k], lyy[k], dt);
        const double volumetric = averaged ? now.value[k] : e.xx + e.yy;
        const Updated to = update<plastic>({sxx[k], syy[k], szz[k], sxy[k]}, e, volumetric, flow);
        sxx[k] = to.stress.xx, syy[k] = to.stress.yy;
        szz[k] = to.stress.zz, sxy[k] = to.stress.xy;
        // exp() of the volume strain to third order: a stretch and its reversal cancel.
        jacobian[k] *= 1. + volumetric * (1. + volumetric * (0.5 + volumetric * (1. / 6.)));
        const double volume = mass[k] * inverse_density * jacobian[k];
        if constexpr (averaged)
        {
          now.volume[k] = volume;
          now.value[k] = -volume * (to.stress.xx + to.stress.yy + to.stress.zz) * (1. / 3.);
        }
        if constexpr (plastic)
        {
          strain[k] += to.plastic;
          dissipated += volume * to.dissipated;
        }
      }
      return dissipated;
    }

    void add(Array<CellSum> &sums, const std::int32_t *const cell, const Chunk &now,
             const std::size_t count)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        CellSum &sum = sums[cell[k]];
        sum.volume += now.volume[k], sum.value += now.value[k];
      }
    }

    template <bool plastic>
    void update_range(Points &points, const Step &step, CellMeans *means, Share &share,
                      const std::size_t begin, const std::size_t end)
    {
      Chunk now;
      for (std::size_t p = begin; p < end; p += chunk)
      {
        const std::size_t count = std::min(chunk, end - p);
        if (means)
        {
          const std::int32_t *const cell = &means->cell[p];
          for (std::size_t k = 0; k < count; ++k)
            now.value[k] = means->rate[cell[k]].mean(0.);
          share.dissipated += update_chunk<plastic, true>(points, step, now, p, count);
          add(means->pressure, cell, now, count);
        }
        else
          share.dissipated += update_chunk<plastic, false>(points, step, now, p, count);
      }
    }

    void relax(Points &points, const Step &step, const CellMeans &means, const std::size_t begin,
               const std::size_t end)
    {
      double mean[chunk];
      for (std::size_t p = begin; p < end; p += chunk)
      {
        const std::size_t count = std::min(chunk, end - p);
        for (std::size_t k = 0; k < count; ++k)
          mean[k] = means.pressure[means.cell[p + k]].mean(0.);
        double *const sxx = &points.sxx[p], *const syy = &points.syy[p],
                      *const szz = &points.szz[p];
        const double rate = step.relaxation;
#pragma omp simd
        for (std::size_t k = 0; k < count; ++k)
        {
          const double change = rate * (mean[k] + (sxx[k] + syy[k] + szz[k]) * (1. / 3.));
          sxx[k] -= change, syy[k] -= change, szz[k] -= change;
        }
      }
    }

    // Written so that a value which is not a number is not right.
    bool right(const Points &points, const Step &step, const std::size_t p)
    {
      const double speed2 = points.vx[p] * points.vx[p] + points.vy[p] * points.vy[p];
      return speed2 < step.speed_limit2 && points.jacobian[p] > 0. &&
             std::isfinite(points.sxx[p] + points.syy[p]) && points.x[p] >= step.lower[0] &&
             points.x[p] <= step.upper[0] && points.y[p] >= step.lower[1] &&
             points.y[p] <= step.upper[1];
    }
  } // namespace

  void collect_rates(const Points &points, const Grid &grid, const Step &step, CellMeans &means,
                     const std::size_t begin, const std::size_t end)
  {
    Chunk now;
    for (std::size_t p = begin; p < end; p += chunk)
    {
      const std::size_t count = std::min(chunk, end - p);
      strain_rates(points, grid, step, now, p, count);
      for (std::size_t k = 0; k < count; ++k)
        means.cell[p + k] = static_cast<std::int32_t>(grid.at(now.i[k], now.j[k]));
      add(means.rate, &means.cell[p], now, count);
    }
  }

  void update_stress(Points &points, const Step &step, CellMeans *means, Share &share,
                     const std::size_t begin, const std::size_t end)
  {
    if (step.plastic)
      update_range<true>(points, step, means, share, begin, end);
    else
      update_range<false>(points, step, means, share, begin, end);
  }

  void move(Points &points, const Moving &moving, const Step &step, const CellMeans *means,
            Share &share, const std::size_t begin, const std::size_t end)
  {
    if (means)
      relax(points, step, *means, begin, end);
    const double *const by_x = moving.vx.empty() ? points.vx.data() : moving.vx.data();
    const double *const by_y = moving.vy.empty() ? points.vy.data() : moving.vy.data();
    const double *const vx = points.vx.data(), *const vy = points.vy.data();
    const double *const sxx = points.sxx.data(), *const syy = points.syy.data();
    const double *const mass = points.mass.data(), *const jacobian = points.jacobian.data();
    double *const x = points.x.data(), *const y = points.y.data();
    const double dt = step.dt, limit = step.speed_limit2;
    const double x0 = step.lower[0], x1 = step.upper[0], y0 = step.lower[1], y1 = step.upper[1];
    double kinetic = 0., largest = share.largest_speed2, wrong = 0.;
#pragma omp simd reduction(+ : kinetic, wrong) reduction(max : largest)
    for (std::size_t p = begin; p < end; ++p)
    {
      const double speed2 = vx[p] * vx[p] + vy[p] * vy[p];
      const double to_x = x[p] + dt * by_x[p], to_y = y[p] + dt * by_y[p];
      kinetic += 0.5 * mass[p] * speed2;
      largest = largest > speed2 ? largest : speed2;
      const bool good = (speed2 < limit) & (jacobian[p] > 0.) &
                        ((sxx[p] - sxx[p]) + (syy[p] - syy[p]) == 0.) & (to_x >= x0) &
                        (to_x <= x1) & (to_y >= y0) & (to_y <= y1);
      wrong += good ? 0. : 1.;
      x[p] = to_x, y[p] = to_y;
    }
    share.kinetic += kinetic, share.largest_speed2 = largest;
    for (std::size_t p = begin; wrong > 0. && share.bad < 0 && p < end; ++p)
      if (!right(points, step, p))
        share.bad = static_cast<std::ptrdiff_t>(p);
  }
} // namespace solid
