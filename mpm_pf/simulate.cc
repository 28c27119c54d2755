#include "simulate.h"

#include <algorithm>

#include "coupling.h"
#include "melt_check.h"

void step(World &w, const double dt)
{
  w.melt_moves = false;
  if (w.walls)
    move_walls(w, dt); // Sec. 3, cut cells [28,29]
  if (w.imposed)
    impose(w, dt); // Sec. 2.3.2, instead of a solid
  if (w.solid && coupled(w))
    move_solid(w, dt); // Eqs. (4)-(6), and the extension of v into the melt [13]-[15]
  else if (w.solid)
    move_solid_alone(w, dt); // Eqs. (4)-(6)

  if (w.melt_moves)
    advect_melt(w, dt); // v . grad of Eqs. (1)-(3), CIP [18]
  if (w.growth)
    grow(w, dt); // right sides of Eqs. (1), (2): operator splitting [16]
  w.time += dt;
  ++w.steps;
}

bool simulate(World &world, Recorder &recorder,
              const std::function<bool(const World &)> &after_step)
{
  const double end = world.scene->clock.end;
  if (world.steps == 0)
  {
    activate_solid(world);
    recorder.observe(world);
  }
  if (!after_step(world))
    return false;
  while (!finished(world))
  {
    const double event = std::min(recorder.next_event(world.time), end);
    double free = coupling_step(world);
    if (world.walls)
      free =
          medium::time_to_compression(*world.walls, world.time, recorder.next_compression(), free);
    const bool lands = event - world.time <= free * (1. + 1e-9);
    step(world, lands ? event - world.time : free);
    check_melt(world);
    if (lands)
      world.time = event; // the sum of steps differs from it by round-off
    if (recorder.is_due(world) || finished(world))
      catch_up(world);
    recorder.observe(world);
    if (!after_step(world))
      return false;
  }
  if (world.time < end * (1. - 1e-12))
    recorder.observe_early_end(world);
  return true;
}
