#include "solid/state_check.h"

#include <algorithm>
#include <cmath>

#include "scene/value.h"
#include "solid/body.h"
#include "solid/energy.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    [[noreturn]] void report(const Solid &solid, const std::string &cause, const std::size_t p)
    {
      const Point place =
          p < solid.points.size() ? Point(solid.points.x[p], solid.points.y[p]) : Point(0., 0.);
      throw NumericalError(cause, solid.steps, solid.time, place);
    }

    void check_point(const Solid &solid, const std::size_t p, const double dt)
    {
      const Points &points = solid.points;
      const Point lower = solid.domain.lower, upper = solid.domain.upper();
      const Point initial = solid.fraction.initial(points, p);
      const auto which = [&]
      {
        return "the material point that started at (" + scene::number_text(initial[0]) + ", " +
               scene::number_text(initial[1]) + ") ";
      };
      if (!std::isfinite(points.x[p] + points.y[p] + points.sxx[p] + points.syy[p]))
        report(solid, which() + "is no longer finite; take a smaller mpm.step_fraction", p);
      if (!(points.jacobian[p] > 0.))
        report(solid,
               which() + "is turned inside out; refine domain.cells or take a smaller "
                         "mpm.step_fraction",
               p);
      if (points.x[p] < lower[0] || points.x[p] > upper[0] || points.y[p] < lower[1] ||
          points.y[p] > upper[1])
        report(solid, which() + "has left the mesh; enlarge domain.size", p);
      if (!(std::hypot(points.vx[p], points.vy[p]) < 0.5 * solid.grid.dx / dt))
        report(solid, which() + "crosses half a cell in one step; take a smaller mpm.step_fraction",
               p);
    }

    std::size_t fastest(const Points &points)
    {
      std::size_t found = 0;
      double largest = 0.;
      for (std::size_t p = 0; p < points.active; ++p)
        if (const double v = std::hypot(points.vx[p], points.vy[p]); v > largest)
          largest = v, found = p;
      return found;
    }

    std::size_t most_stressed(const Solid &solid)
    {
      const Points &points = solid.points;
      std::size_t found = 0;
      double largest = 0.;
      for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double s = std::abs(points.sxx[p]) + std::abs(points.syy[p]) +
                         std::abs(points.szz[p]) + std::abs(points.sxy[p]);
        if (s > largest)
          largest = s, found = p;
      }
      return found;
    }

    // Energy of strains that are rounding alone.
    double rounding(const Solid &solid)
    {
      return 1e-18 * solid.material.wave_modulus() * solid.domain.size.prod();
    }

    // Stresses may run away where nothing gets fast. Their energy is a sum over all points, so it
    // is computed now and then. In the first step of a load the stresses are there before the work
    // that they take is counted, but not before that of the motion, which is far more: a step is
    // short against a wave's way through the material.
    void check_energy(const Solid &solid)
    {
      constexpr long steps_between = 32;
      if (solid.steps % steps_between == 0 &&
          -missing_energy(solid) > solid.energy.largest + rounding(solid))
        report(solid,
               "the energy of motion and stress exceeds twice all that was ever put in; refine "
               "domain.cells, give more mpm.points_per_cell or take a smaller mpm.step_fraction",
               most_stressed(solid));
    }
  } // namespace

  void check_state(Solid &solid, const double dt)
  {
    double kinetic = 0., speed2 = 0.;
    // A block names the first of its bad points, which may have been mended by a wall alone.
    if (std::any_of(solid.shares.begin(), solid.shares.end(),
                    [](const Share &share) { return share.bad >= 0; }))
    {
      stop_at_walls(solid, solid.time);
      for (std::size_t p = 0; p < solid.points.size(); ++p)
        check_point(solid, p, dt);
    }
    for (const Share &share : solid.shares)
    {
      kinetic += share.kinetic, solid.energy.dissipated += share.dissipated;
      solid.energy.strained += share.strained;
      speed2 = std::max(speed2, share.largest_speed2);
    }
    solid.energy.kinetic = kinetic;
    solid.energy.kinetic_time += dt * kinetic;
    solid.energy.internal_time += dt * (solid.energy.elastic_start + solid.energy.strained);
    solid.speed = std::sqrt(speed2);
    solid.grid.drift += dt * std::max(solid.speed, solid.supports.speed);
    const double work = solid.supports.work + solid.loads.work;
    solid.energy.largest = std::max(solid.energy.largest, solid.energy.start + std::abs(work));
    const double given = solid.energy.start + solid.supports.work_done + solid.loads.work_done;
    if (kinetic > 2. * given + rounding(solid))
      report(solid,
             "the kinetic energy exceeds twice all that was ever put in; take a smaller "
             "mpm.step_fraction",
             fastest(solid.points));
    check_energy(solid);
  }
} // namespace solid
