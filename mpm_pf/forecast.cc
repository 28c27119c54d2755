#include "forecast.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

#include <omp.h>

#include "costs.h"
#include "coupling.h"
#include "forecast_output.h"
#include "forecast_probes.h"
#include "record/stopwatch.h"
#include "scene/quantities.h"
#include "simulate.h"
#include "step_count.h"

namespace
{
  double sum(const std::map<std::string, double> &parts)
  {
    return std::accumulate(parts.begin(), parts.end(), 0.,
                           [](const double total, const auto &part)
                           { return total + part.second; });
  }

  /// A step no longer than `step`, of which the first try and `most` more stay before the end of
  /// the run: what drives the solid need not make sense beyond it.
  double within_the_run(const World &world, const double step, const int most)
  {
    return std::min(step, expected_end(world) / (1. + most));
  }

  /// A solid that is there from the start: its own steps, timed.
  void forecast_solid(World &world, Forecast &forecast)
  {
    const double step = solid::stable_step(*world.solid);
    const double steps = count_solid_steps(world).substeps;
    forecast.counts["points"] = static_cast<double>(solid::points(*world.solid));
    forecast.counts["steps"] = steps;
    const int most = static_cast<int>(std::clamp(steps, 1., double(probe_calls)));
    constexpr double one = 0.95; // as soon as something moves, a whole step would be done in two
    const double tried = within_the_run(world, one * step, most);
    forecast.seconds["solid"] =
        steps * seconds_of([&] { solid::advance(*world.solid, tried); }, probe_budget_s, most);
    forecast.counts["cells"] = static_cast<double>(solid::cells(*world.solid));
  }

  /// How often what need not be done at every coupling step will be.
  void count_intervals(const World &world, const double steps, const double step_length,
                       Forecast &forecast)
  {
    if (world.uncarried)
      forecast.counts["advections"] =
          steps / steps_between_advections(world, shift_of_a_step(world, step_length));
    if (world.extension->interval > 1)
      forecast.counts["measurements of the distance, at least"] = steps / world.extension->interval;
  }

  /// A solid with a passive marker: its steps, the extension of its velocity and what that carries.
  void forecast_marked_solid(World &world, Forecast &forecast)
  {
    const double end = expected_end(world), step_length = std::min(coupling_step(world), end);
    const double solid_step = solid::stable_step(*world.solid);
    const StepCount count = count_solid_steps(world);
    const double steps = count.couplings;
    forecast.counts["points"] = static_cast<double>(solid::points(*world.solid));
    forecast.counts["coupling steps"] = steps;
    forecast.counts["steps"] = count.substeps;
    // What is done every few steps only comes up once in each call that is timed.
    const int period = std::max(world.uncarried ? world.uncarried->interval : 1,
                                std::min(world.extension->interval, world.extension->map_interval));
    const int in_a_call = static_cast<int>(std::clamp(steps / 2., 1., double(period)));
    const int most = static_cast<int>(std::clamp(steps / in_a_call, 1., double(probe_calls)));
    const double tried = within_the_run(world, step_length, in_a_call * (1 + most));
    const auto call = [&]
    {
      for (int k = 0; k < in_a_call; ++k)
        step(world, tried);
    };
    const double coupling = seconds_of(call, probe_budget_s, most) / in_a_call;
    // What is cut short has fewer of the solid's steps in it, and all of the rest.
    const double tried_steps = std::max(1., std::ceil(tried / solid_step - 1e-9));
    const double moves_nothing = 1e-3 * tried / probe_calls; // and stays within the run
    const double each = seconds_of([&] { solid::advance(*world.solid, moves_nothing); },
                                   probe_budget_s, probe_calls);
    forecast.seconds["solid"] =
        steps * std::max(0., coupling - tried_steps * each) + count.substeps * each;
    count_intervals(world, steps, step_length, forecast);
    forecast.counts["cells"] = static_cast<double>(solid::cells(*world.solid));
  }

  /// What the largest snapshot of so many points holds while it is written: a column for each
  /// quantity, positions, and what strains are fitted with.
  double snapshot_bytes(const scene::Scene &scene, const double points)
  {
    constexpr std::size_t besides = 8; // columns
    std::size_t most = 0;
    for (const scene::Probe &probe : scene.probes)
      if (std::holds_alternative<scene::SnapshotProbe>(probe.kind))
        most = std::max(
            most, besides + (probe.of.empty() ? scene::solid_quantities.size() : probe.of.size()));
    return points * static_cast<double>(most * sizeof(double));
  }
} // namespace

double Forecast::solver_bytes() const
{
  return sum(bytes);
}

double Forecast::cpu_s() const
{
  return sum(seconds);
}

Forecast make_forecast(const scene::Scene &scene, const int threads, const bool force)
{
  omp_set_num_threads(threads);
  Forecast forecast;
  // Before the world exists, so that the probe's arrays add nothing to the memory in use at once.
  const double triad = scene.growth
                           ? triad_seconds(static_cast<std::size_t>(scene.domain.cells[0]) *
                                           static_cast<std::size_t>(scene.domain.cells[1]))
                           : 0.;
  const record::Stopwatch setup;
  World world = build_world(scene, threads, force);
  forecast.seconds["set-up"] = setup.cpu_seconds();
  if (world.mesh)
    forecast.counts["nodes"] = static_cast<double>(world.mesh->node_count());
  if (scene.growth)
    forecast_crystal(world, triad, forecast);
  else
  {
    if (world.extension)
      forecast_marked_solid(world, forecast);
    else if (world.solid)
      forecast_solid(world, forecast);
    if (world.growth)
    {
      const double steps = expected_end(world) / growth_step_taken(world);
      forecast.counts["growth steps"] = steps;
      forecast.seconds["growth"] = steps * seconds_per_growth_step(world);
    }
    forecast_advection(world, expected_end(world), forecast);
    forecast.bytes = memory(world);
  }
  // The world has been at work: what it has taken is known, and what it will still take comes on
  // top.
  forecast.resident_bytes =
      record::peak_rss_bytes() + std::max(0., forecast.solver_bytes() - sum(memory(world)));
  if (const auto points = forecast.counts.find("points"); points != forecast.counts.end())
    forecast.resident_bytes += snapshot_bytes(scene, points->second);
  forecast_output(world, forecast); // last: what it holds meanwhile is counted just above
  return forecast;
}

std::string describe(const Forecast &forecast)
{
  std::ostringstream out;
  out << std::setprecision(4);
  for (const auto &[name, value] : forecast.counts)
    out << "  " << name << ": " << value << '\n';
  for (const auto &[what, bytes] : forecast.bytes)
    out << "  memory, " << what << ": " << bytes / 1e6 << " MB\n";
  out << "  memory, all modules: " << forecast.solver_bytes() / 1e6 << " MB; resident "
      << forecast.resident_bytes / 1e6 << " MB\n";
  for (const auto &[what, seconds] : forecast.seconds)
    out << "  time, " << what << ": " << seconds << " s of CPU\n";
  out << "  time, all: " << forecast.cpu_s() << " s of CPU\n";
  out << "forecast cpu_s=" << forecast.cpu_s() << " solver_bytes=" << forecast.solver_bytes()
      << " resident_bytes=" << forecast.resident_bytes << '\n';
  return out.str();
}
