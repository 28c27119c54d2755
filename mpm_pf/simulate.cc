#include "simulate.h"

#include <algorithm>
#include <cmath>

namespace
{
  /// v . grad of Eqs. (1)-(3): everything that the melt carries follows the velocity over dt.
  void carry(World &w, const double dt)
  {
    if (w.phase)
      w.advection->advect(w.phase->value, w.phase->gradients, *w.velocity, dt); // Eq. (1)
    if (w.heat)
      w.advection->advect(w.heat->value, w.heat->gradients, *w.velocity, dt); // Eq. (2)
    if (w.orientation && w.scene->orientation->turning)
    {
      melt::let_vary(*w.orientation, *w.mesh);
      melt::turn(*w.orientation, *w.velocity, dt, *w.mesh, *w.advection); // Eq. (3)
    }
  }

  /// Right sides of Eqs. (1) and (2) over dt, in equal explicit steps below their limit.
  void grow(World &w, const double dt)
  {
    const long steps = std::max(1L, std::lround(std::ceil(dt / growth_step(w) * (1. - 1e-9))));
    w.growth->advance({w.phase ? &w.phase->value : nullptr, w.heat ? &w.heat->value : nullptr,
                       w.orientation.get(), w.noise.get()},
                      dt / static_cast<double>(steps), steps);
  }
} // namespace

void step(World &w, const double dt)
{
  if (w.imposed)
    w.imposed->write(w.time + dt / 2, *w.mesh, *w.velocity); // Sec. 2.3.2, instead of a solid

  if (w.solid)
    solid::advance(*w.solid, dt); // Eqs. (4)-(6), as many substeps as its own limit asks

  if (w.imposed && w.imposed->crossing_rate() > 0.)
    carry(w, dt);
  if (w.growth)
    grow(w, dt); // operator splitting [16]
  w.time += dt;
  ++w.steps;
}

bool simulate(World &world, Recorder &recorder, const std::function<bool(const World &)> &look)
{
  const double end = world.scene->clock.end;
  if (world.steps == 0)
    recorder.observe(world);
  while (world.time < end * (1. - 1e-12))
  {
    const double event = std::min(recorder.next_event(world.time), end);
    const double free = coupling_step(world);
    const bool lands = event - world.time <= free * (1. + 1e-9);
    step(world, lands ? event - world.time : free);
    if (lands)
      world.time = event; // the sum of steps differs from it by round-off
    recorder.observe(world);
    if (!look(world))
      return false;
  }
  return true;
}
