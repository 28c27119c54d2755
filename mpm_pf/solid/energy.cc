#include "solid/energy.h"

#include <algorithm>
#include <cmath>

#include "solid/body.h"

namespace solid
{
  namespace
  {
    template <typename F>
    double sum(const Solid &solid, F &&f)
    {
      double total = 0.;
      for (std::size_t p = 0; p < solid.points.size(); ++p)
        total += f(p);
      return total;
    }
  } // namespace

  double kinetic_energy_of(const Points &points, const std::size_t p)
  {
    return 0.5 * points.mass[p] * (points.vx[p] * points.vx[p] + points.vy[p] * points.vy[p]);
  }

  double elastic_energy_of(const Solid &solid, const std::size_t k)
  {
    const Points &points = solid.points;
    const Stress s{points.sxx[k], points.syy[k], points.szz[k], points.sxy[k]};
    const double q = von_mises(s), p = pressure(s);
    return points.mass[k] / solid.material.density * points.jacobian[k] *
           (q * q / (6. * solid.material.shear) + 0.5 * p * p / solid.material.bulk);
  }

  double kinetic_energy(const Solid &solid)
  {
    const Points &points = solid.points;
    return sum(solid, [&](const std::size_t p) { return kinetic_energy_of(points, p); });
  }

  double elastic_energy(const Solid &solid)
  {
    return sum(solid, [&](const std::size_t p) { return elastic_energy_of(solid, p); });
  }

  Point momentum(const Solid &solid)
  {
    const Points &points = solid.points;
    return {sum(solid, [&](const std::size_t p) { return points.mass[p] * points.vx[p]; }),
            sum(solid, [&](const std::size_t p) { return points.mass[p] * points.vy[p]; })};
  }

  double area(const Solid &solid)
  {
    const Points &points = solid.points;
    return sum(solid, [&](const std::size_t p)
               { return points.mass[p] / solid.material.density * points.jacobian[p]; });
  }

  double mass(const Solid &solid)
  {
    return sum(solid, [&](const std::size_t p) { return solid.points.mass[p]; });
  }

  void start_energy_account(Solid &solid)
  {
    const Points &points = solid.points;
    solid.speed = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      solid.speed = std::max(solid.speed, std::hypot(points.vx[p], points.vy[p]));
    solid.energy.elastic_start = elastic_energy(solid);
    solid.energy.start = solid.energy.largest = kinetic_energy(solid) + solid.energy.elastic_start;
  }

  namespace
  {
    // What came in and neither moves the points nor has strained them.
    double transfer_loss(const Solid &solid, const double kinetic)
    {
      const Energy &energy = solid.energy;
      return solid.supports.work + solid.loads.work + (energy.start - energy.elastic_start) -
             kinetic - energy.strained;
    }

    // What has strained them and is nowhere any more.
    double balance(const Solid &solid, const double elastic)
    {
      return solid.energy.strained - (elastic - solid.energy.elastic_start) -
             solid.energy.dissipated;
    }
  } // namespace

  double missing_energy(const Solid &solid)
  {
    return transfer_loss(solid, kinetic_energy(solid)) + balance(solid, elastic_energy(solid));
  }

  LostEnergy lost_energy(const Solid &solid)
  {
    const double largest = solid.energy.largest;
    if (!(largest > 0.))
      return {};
    return {transfer_loss(solid, kinetic_energy(solid)) / largest,
            balance(solid, elastic_energy(solid)) / largest};
  }

  double mean_kinetic_share(const Solid &solid)
  {
    const Energy &energy = solid.energy;
    return energy.internal_time > 0. ? energy.kinetic_time / energy.internal_time : 0.;
  }

  History history(const Solid &solid)
  {
    const double kinetic = kinetic_energy(solid), elastic = elastic_energy(solid);
    const double work = solid.supports.work + solid.loads.work;
    const double internal = elastic + solid.energy.dissipated;
    const Point p = momentum(solid);
    History history;
    using scene::Dimension;
    history.names = {"kinetic_energy", "elastic_energy", "plastic_dissipation",
                     "external_work",  "transfer_loss",  "energy_balance",
                     "momentum_x",     "momentum_y",     "area",
                     "mass",           "largest_speed",  "kinetic_to_internal"};
    history.dimensions = {Dimension::energy,   Dimension::energy,   Dimension::energy,
                          Dimension::energy,   Dimension::energy,   Dimension::energy,
                          Dimension::momentum, Dimension::momentum, Dimension::area,
                          Dimension::mass,     Dimension::speed,    Dimension::none};
    history.row = {kinetic,
                   elastic,
                   solid.energy.dissipated,
                   work,
                   transfer_loss(solid, kinetic),
                   balance(solid, elastic),
                   p[0],
                   p[1],
                   area(solid),
                   mass(solid),
                   solid.speed,
                   internal > 0. ? kinetic / internal : 0.};
    return history;
  }
} // namespace solid
