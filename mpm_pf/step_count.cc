#include "step_count.h"

#include <algorithm>
#include <cmath>

#include "recorded_times.h"

namespace
{
  double calls_of(const double length, const double limit)
  {
    return std::max(1., std::ceil(length / limit - 1e-9)); // as solid::advance() has it
  }
} // namespace

StepCount count_steps(const World &world, const double from, const double to, const double coupling,
                      const double substep)
{
  const double tolerance = 1e-9 * world.scene->clock.end;
  std::vector<double> stops = recorded_times(*world.scene);
  stops.push_back(to);
  StepCount count;
  double time = from;
  for (const double stop : stops)
  {
    const double length = std::min(stop, to) - time;
    if (length <= tolerance)
      continue;
    const double whole = calls_of(length, coupling) - 1., rest = length - whole * coupling;
    count.couplings += whole + 1.;
    if (whole > 0.) // else the coupling may be without bound
      count.substeps += whole * calls_of(coupling, substep);
    count.substeps += calls_of(rest, substep);
    time = std::min(stop, to);
  }
  return count;
}

StepCount count_solid_steps(const World &world)
{
  return count_steps(world, 0., expected_end(world), coupling_step(world),
                     solid::stable_step(*world.solid));
}
