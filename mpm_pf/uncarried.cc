#include "uncarried.h"

#include <algorithm>
#include <cmath>

namespace
{
  constexpr int ghosts = medium::ghost_layers;

  /// Scales every node and ghost.
  void scale(medium::Field<double> &field, const double factor)
  {
#pragma omp parallel for schedule(static)
    for (int j = -ghosts; j < field.nodes(1) + ghosts; ++j)
    {
      double *row = field.row(j);
      for (int i = -ghosts; i < field.nodes(0) + ghosts; ++i)
        row[i] *= factor;
    }
  }

  struct Largest
  {
    double way = 0., step = 0.; // length, over nodes and ghosts
  };

  Largest add(const medium::Field<double> &velocity, const double dt, medium::Field<double> &way)
  {
    double all = 0., last = 0.;
#pragma omp parallel for schedule(static) reduction(max : all, last)
    for (int j = -ghosts; j < way.nodes(1) + ghosts; ++j)
    {
      const double *v = velocity.row(j);
      double *sum = way.row(j);
      for (int i = -ghosts; i < way.nodes(0) + ghosts; ++i)
      {
        const double step = v[i] * dt;
        sum[i] += step;
        all = std::max(all, std::abs(sum[i])), last = std::max(last, std::abs(step));
      }
    }
    return {all, last};
  }
} // namespace

void add_step(Uncarried &u, const medium::Velocity &velocity, const double dt,
              const medium::Mesh &mesh)
{
  const Largest x = add(velocity.x, dt, u.way.x), y = add(velocity.y, dt, u.way.y);
  u.time += dt;
  ++u.steps;
  u.shift = std::max(x.way / mesh.spacing[0], y.way / mesh.spacing[1]);
  u.last = std::max(x.step / mesh.spacing[0], y.step / mesh.spacing[1]);
}

bool is_due(const Uncarried &u, const double room)
{
  return u.steps >= u.interval || u.shift + u.last > room;
}

const medium::Velocity &mean_velocity(Uncarried &u)
{
  scale(u.way.x, 1. / u.time), scale(u.way.y, 1. / u.time);
  return u.way;
}

void restart(Uncarried &u)
{
  scale(u.way.x, 0.), scale(u.way.y, 0.);
  u.time = 0., u.steps = 0;
}

double steps_between_advections(const int interval, const double shift, const double room)
{
  const double fit = shift > 0. ? std::floor(room / shift * (1. + 1e-9)) : interval;
  return std::clamp(fit, 1., static_cast<double>(interval));
}
