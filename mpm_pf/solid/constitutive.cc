#include "solid/constitutive.h"

namespace solid
{
  namespace
  {
    // Points whose cells are looked up before they are computed side by side.
    constexpr std::size_t chunk = 64;

    // Means of the cells of some points.
    struct Chunk
    {
      double strain[chunk], pressure[chunk];
    };

    template <bool plastic, bool averaged>
    bool update_chunk(Points &points, const Step &step, const Chunk &cell, Share &share,
                      const PointRange range)
    {
      const std::size_t begin = range.begin, count = range.size();
      double *const sxx = &points.sxx[begin], *const syy = &points.syy[begin];
      double *const szz = &points.szz[begin], *const sxy = &points.sxy[begin];
      double *const strain = &points.plastic[begin], *const jacobian = &points.jacobian[begin];
      const double *const lxx = &points.lxx[begin], *const lxy = &points.lxy[begin];
      const double *const lyx = &points.lyx[begin], *const lyy = &points.lyy[begin];
      const double *const mass = &points.mass[begin];
      const Flow flow = step.flow;
      const double dt = step.dt, inverse_density = step.inverse_density;
      const double relaxation = step.relaxation, compressibility = 1. / flow.bulk;
      double dissipated = 0., strained = 0., wrong = 0.;
#pragma omp simd reduction(+ : dissipated, strained, wrong)
      for (std::size_t k = 0; k < count; ++k)
      {
        const Increment e = increment(lxx[k], lxy[k], lyx[k], lyy[k], dt);
        Stress old{sxx[k], syy[k], szz[k], sxy[k]};
        const double volumetric = averaged ? cell.strain[k] : e.xx + e.yy;
        double swelling = volumetric;
        if constexpr (averaged)
        {
          const double change = relaxation * (cell.pressure[k] - pressure(old));
          old.xx -= change, old.yy -= change, old.zz -= change;
          swelling -= change * compressibility; // volume goes with pressure, anti_locking.h
        }
        const Updated to = update<plastic>(old, e, volumetric, flow);
        sxx[k] = to.stress.xx, syy[k] = to.stress.yy;
        szz[k] = to.stress.zz, sxy[k] = to.stress.xy;
        // exp() of the volume strain to third order: a stretch and its reversal cancel.
        const double stretched =
            jacobian[k] * (1. + swelling * (1. + swelling * (0.5 + swelling * (1. / 6.))));
        jacobian[k] = stretched;
        const double volume = mass[k] * inverse_density * stretched;
        strained += volume * to.work;
        if constexpr (plastic)
        {
          strain[k] += to.plastic;
          dissipated += volume * to.dissipated;
        }
        const double zero = (to.stress.xx - to.stress.xx) + (to.stress.yy - to.stress.yy);
        wrong += (stretched > 0.) & (zero == 0.) ? 0. : 1.;
      }
      share.dissipated += dissipated, share.strained += strained;
      return wrong == 0.;
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

    void find_wrong(const Points &points, const Step &step, Share &share, const PointRange range)
    {
      for (std::size_t p = range.begin; share.bad < 0 && p < range.end; ++p)
        if (!right(points, step, p))
          share.bad = static_cast<std::ptrdiff_t>(p);
    }

    template <bool plastic>
    void update_range(Points &points, const Step &step, const CellMeans *means, Share &share,
                      const PointRange range)
    {
      Chunk now;
      for (std::size_t p = range.begin; p < range.end; p += chunk)
      {
        const PointRange some{p, std::min(p + chunk, range.end)};
        for (std::size_t k = 0; means && k < some.size(); ++k)
        {
          const CellMeans::Mean &mean = means->mean[means->cell[p + k]];
          now.strain[k] = mean.strain, now.pressure[k] = mean.pressure;
        }
        const bool good = means ? update_chunk<plastic, true>(points, step, now, share, some)
                                : update_chunk<plastic, false>(points, step, now, share, some);
        if (!good)
          find_wrong(points, step, share, some);
      }
    }
  } // namespace

  void update_stress(Points &points, const Step &step, const CellMeans *means, Share &share,
                     const PointRange range)
  {
    if (step.plastic)
      update_range<true>(points, step, means, share, range);
    else
      update_range<false>(points, step, means, share, range);
  }

  void move(Points &points, const Moving &by, const Step &step, Share &share,
            const PointRange range)
  {
    const std::size_t begin = range.begin;
    const double *const vx = &points.vx[begin], *const vy = &points.vy[begin];
    const double *const by_x = by.vx ? by.vx : vx, *const by_y = by.vy ? by.vy : vy;
    const double *const mass = &points.mass[begin];
    double *const x = &points.x[begin], *const y = &points.y[begin];
    const double dt = step.dt, limit = step.speed_limit2;
    const double x0 = step.lower[0], x1 = step.upper[0], y0 = step.lower[1], y1 = step.upper[1];
    double kinetic = 0., largest = share.largest_speed2, wrong = 0.;
#pragma omp simd reduction(+ : kinetic, wrong) reduction(max : largest)
    for (std::size_t k = 0; k < range.size(); ++k)
    {
      const double speed2 = vx[k] * vx[k] + vy[k] * vy[k];
      const double to_x = x[k] + dt * by_x[k], to_y = y[k] + dt * by_y[k];
      kinetic += 0.5 * mass[k] * speed2;
      largest = largest > speed2 ? largest : speed2;
      const bool good =
          (speed2 < limit) & (to_x >= x0) & (to_x <= x1) & (to_y >= y0) & (to_y <= y1);
      wrong += good ? 0. : 1.;
      x[k] = to_x, y[k] = to_y;
    }
    share.kinetic += kinetic, share.largest_speed2 = largest;
    if (wrong > 0.)
      find_wrong(points, step, share, range);
  }
} // namespace solid
