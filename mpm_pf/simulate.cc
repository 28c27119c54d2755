#include "simulate.h"

#include <algorithm>

void step(World &w, const double dt)
{
  if (w.solid)
    solid::advance(*w.solid, dt); // Eqs. (4)-(6), as many substeps as its own limit asks
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
