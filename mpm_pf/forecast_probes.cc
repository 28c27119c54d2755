#include "forecast_probes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "coupling.h"
#include "record/stopwatch.h"

double seconds_of(const std::function<void()> &call, const double budget, const int most)
{
  call();
  // In rounds, of which the least disturbed counts: neighbours slow a probe of some hundredths of a
  // second by a factor, a run by its mean.
  constexpr int rounds = 4;
  const record::Stopwatch whole;
  double least = std::numeric_limits<double>::infinity();
  int calls = 0;
  do
  {
    const record::Stopwatch round;
    int of_round = 0;
    do
    {
      call();
      ++of_round;
    } while (round.cpu_seconds() < budget / rounds && calls + of_round < most);
    least = std::min(least, round.cpu_seconds() / of_round);
    calls += of_round;
  } while (whole.cpu_seconds() < budget && calls < most);
  return least;
}

double triad_seconds(const std::size_t nodes)
{
  std::vector<double> a(nodes, 0.), b(nodes, 1.), c(nodes, 2.);
  double s = 0.5;
  const double pass = seconds_of(
      [&]
      {
        for (std::size_t i = 0; i < nodes; ++i)
          a[i] = b[i] + s * c[i];
        s = 0.5 + 1e-9 * a[nodes / 2];
      },
      0.01, 100);
  return pass / static_cast<double>(nodes);
}

double shift_of_a_step(const World &world, const double step)
{
  const double speed = solid::density_scaling(*world.solid).reference_speed;
  return step * speed / world.mesh->spacing.minCoeff();
}

double growth_step_taken(const World &world)
{
  return std::min(growth_step(world), coupling_step(world));
}

double seconds_per_growth_step(World &world)
{
  // From one coupling to the next; a coupling step may be shorter than a growth step. What is spent
  // once a call (copies, conversions of precision) counts by the steps of a whole call.
  constexpr double few = 16.;
  const double steps =
      std::max(1., std::ceil(coupling_step(world) / growth_step(world) * (1. - 1e-9)));
  const auto seconds_of_call = [&](const double count)
  {
    const double length = count * growth_step_taken(world);
    return seconds_of([&] { grow(world, length); }, probe_budget_s, probe_calls);
  };
  const double short_call = seconds_of_call(std::min(steps, few));
  if (steps < 4. * few)
    return short_call / std::min(steps, few);
  const double each = std::max(0., seconds_of_call(2. * few) - short_call) / few;
  return each + std::max(0., short_call - few * each) / steps;
}

namespace
{
  /// Coupling steps until `end` of a motion that may be faster at one time than at another.
  double imposed_steps(World &world, const double end)
  {
    constexpr int samples = 16;
    const double now = world.time;
    double steps = 0.;
    for (int k = 0; k < samples; ++k)
    {
      world.time = (k + 0.5) / samples * end;
      steps += end / samples / coupling_step(world);
    }
    world.time = now;
    return steps;
  }
} // namespace

void forecast_advection(World &world, const double end, Forecast &forecast)
{
  if (!world.imposed || !world.imposed->may_move())
    return;
  const double step = coupling_step(world);
  const double steps = std::max(1., imposed_steps(world, end));
  forecast.counts["coupling steps"] = steps;
  world.imposed->evaluate(world.time, *world.mesh, *world.velocity);
  const double shift = step * medium::crossing_rate(*world.velocity, *world.mesh);
  const double apart = steps_between_advections(world, shift);
  if (world.uncarried)
    forecast.counts["advections"] = steps / apart;
  // As short that it moves nothing; its advections come as they will with whole steps.
  const auto write = [&]
  {
    for (int k = 0; k < static_cast<int>(apart); ++k)
    {
      world.imposed->evaluate(world.time, *world.mesh, *world.velocity);
      advect_melt(world, 1e-3 * step);
    }
    catch_up(world);
  };
  forecast.seconds["advection"] =
      steps / apart *
      seconds_of(write, probe_budget_s, static_cast<int>(std::clamp(steps / apart, 1., 50.)));
}
