#include "forecast.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <vector>

#include <omp.h>

#include "accounts.h"
#include "coupling.h"
#include "forecast_growth.h"
#include "record/provenance.h"
#include "simulate.h"

namespace
{
  double sum(const std::map<std::string, double> &parts)
  {
    return std::accumulate(parts.begin(), parts.end(), 0.,
                           [](const double total, const auto &part)
                           { return total + part.second; });
  }

  /// CPU seconds of one call: after a first one that warms up, as many as `budget` holds, at most
  /// `most`.
  double seconds_of(const std::function<void()> &call, const double budget, const int most)
  {
    call();
    const double begin = record::cpu_seconds();
    int calls = 0;
    do
    {
      call();
      ++calls;
    } while (record::cpu_seconds() - begin < budget && calls < most);
    return (record::cpu_seconds() - begin) / calls;
  }

  constexpr double probe_budget_s = 0.04; // of each probe
  constexpr int probe_calls = 400;

  /// CPU seconds of one pass a = b + s c over `nodes` doubles, per node: the unit of the kernels.
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

  /// A solid that is there from the start: its own steps, timed.
  void foretell_solid(World &world, Forecast &forecast)
  {
    const double step = solid::stable_step(*world.solid);
    const double steps = world.scene->clock.end / step;
    forecast.counts["points"] = static_cast<double>(solid::points(*world.solid));
    forecast.counts["steps"] = steps;
    const int most = static_cast<int>(std::clamp(steps, 1., double(probe_calls)));
    forecast.seconds["solid"] =
        steps * seconds_of([&] { solid::advance(*world.solid, step); }, probe_budget_s, most);
    forecast.counts["cells"] = static_cast<double>(solid::cells(*world.solid));
  }

  /// A solid with a passive marker: its steps, the extension of its velocity and what that carries.
  void foretell_marked_solid(World &world, Forecast &forecast)
  {
    const double step_length = std::min(coupling_step(world), world.scene->clock.end);
    const double steps = world.scene->clock.end / step_length;
    forecast.counts["points"] = static_cast<double>(solid::points(*world.solid));
    forecast.counts["coupling steps"] = steps;
    forecast.counts["steps"] = world.scene->clock.end / solid::stable_step(*world.solid);
    const int most = static_cast<int>(std::clamp(steps, 1., double(probe_calls)));
    forecast.seconds["solid"] =
        steps * seconds_of([&] { step(world, step_length); }, probe_budget_s, most);
    forecast.counts["cells"] = static_cast<double>(solid::cells(*world.solid));
  }

  /// Growth steps from one coupling to the next; a coupling step may be shorter than a growth step.
  double growth_steps_per_call(const World &world)
  {
    return std::clamp(std::ceil(coupling_step(world) / growth_step(world) * (1. - 1e-9)), 1., 16.);
  }

  /// Length of a growth step as it will be taken. Time.
  double growth_step_taken(const World &world)
  {
    return std::min(growth_step(world), coupling_step(world));
  }

  /// Heat alone, or growth that a few steps stand for.
  double seconds_per_growth_step(World &world)
  {
    const double steps = growth_steps_per_call(world), length = steps * growth_step_taken(world);
    return seconds_of([&] { grow(world, length); }, probe_budget_s, probe_calls) / steps;
  }

  void foretell_growth(World &world, const GrowthLoad &load, const double triad, Forecast &forecast)
  {
    const double steps = load.end / growth_step_taken(world);
    const double seconds = seconds_per_growth_step(world);
    const auto &tiles = world.growth->tiles();
    const double tile = medium::Tiles::width * medium::Tiles::height;
    const double nodes = static_cast<double>(world.mesh->node_count());
    const auto count = [&](const medium::Activity activity)
    { return std::min(nodes, tile * static_cast<double>(tiles.count(activity))); };
    // Heat alone is bound by memory: one triad a node (benchmarks/kernels), half in float.
    const bool single = world.scene->growth->precision == scene::Precision::single_precision;
    const double heat_alone = (single ? 0.6 : 1.1) * triad;
    const double active_now = count(medium::Activity::active);
    const double each =
        std::max(2. * heat_alone, (seconds - heat_alone * count(medium::Activity::heat_only)) /
                                      std::max(1., active_now));
    forecast.counts["growth steps"] = steps;
    forecast.counts["active nodes, mean"] = load.active_nodes;
    forecast.counts["heated nodes, mean"] = load.heated_nodes;
    forecast.seconds["growth"] =
        steps * (each * load.active_nodes + heat_alone * load.heated_nodes);
  }

  /// What an imposed motion carries, timed.
  void foretell_advection(World &world, const double end, Forecast &forecast)
  {
    const double step = coupling_step(world);
    if (!world.imposed || world.imposed->crossing_rate() <= 0.)
      return;
    const double steps = std::max(1., end / step);
    forecast.counts["coupling steps"] = steps;
    const double write = seconds_of(
        [&]
        {
          world.imposed->write(world.time, *world.mesh, *world.velocity);
          carry(world, 1e-3 * step);
        },
        probe_budget_s, static_cast<int>(std::clamp(steps, 1., 50.)));
    forecast.seconds["advection"] = steps * write;
  }

  /// A solid that a wall finds when it arrives: points are sown over the crystal, then the solid,
  /// its velocity's extension and the melt's advection work until the walls have travelled. In
  /// triads a point or a node as measured by benchmarks/kernels.
  void foretell_pressing(const World &world, const GrowthLoad &load, const double triad,
                         Forecast &forecast)
  {
    constexpr double triads_per_point = 55., triads_per_carried_node = 12.,
                     triads_per_extended_node = 25.;
    const scene::Scene &scene = *world.scene;
    const scene::Mpm mpm = scene.mpm.value_or(scene::Mpm{});
    const double cell = world.mesh->spacing.prod(), duration = load.end - load.pressed_from;
    const double points = load.solid_area / cell * mpm.points_per_cell[0] * mpm.points_per_cell[1];
    const double steps = duration / solid::stable_step(*world.solid);
    const double nodes = static_cast<double>(world.mesh->node_count());
    const double couplings = duration / coupling_step(world);
    const double fields = 1. + (world.heat ? 1. : 0.) + (world.orientation ? 1. : 0.);
    forecast.counts["points"] = points;
    forecast.counts["steps"] = steps;
    forecast.counts["coupling steps"] = couplings;
    forecast.seconds["solid"] = steps * points * triads_per_point * triad;
    forecast.seconds["advection"] =
        couplings * nodes * triad * (fields * triads_per_carried_node + triads_per_extended_node);
    constexpr double bytes_per_point = 130., bytes_per_grid_node = 100.;
    forecast.bytes["solid points"] = points * bytes_per_point;
    forecast.bytes["solid grid"] = 1.15 * load.solid_area / cell * bytes_per_grid_node;
    forecast.bytes["solid scratch"] = points * 24.;
    if (world.phase)
      forecast.bytes["phase field"] = 5. * static_cast<double>(world.phase->value.bytes());
    if (world.heat)
      forecast.bytes["heat"] = 5. * static_cast<double>(world.heat->value.bytes());
  }

  void foretell_crystal(World &world, const double triad, Forecast &forecast)
  {
    const GrowthLoad load = growth_load(world);
    foretell_growth(world, load, triad, forecast);
    foretell_advection(world, load.end, forecast);
    forecast.bytes = memory(world);
    if (world.solid)
      foretell_pressing(world, load, triad, forecast);
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

Forecast foretell(const scene::Scene &scene, const int threads)
{
  omp_set_num_threads(threads);
  Forecast forecast;
  // Before the world exists, so that the probe's arrays add nothing to the memory in use at once.
  const double triad = scene.growth
                           ? triad_seconds(static_cast<std::size_t>(scene.domain.cells[0]) *
                                           static_cast<std::size_t>(scene.domain.cells[1]))
                           : 0.;
  const double begin = record::cpu_seconds();
  World world = build_world(scene, threads);
  forecast.seconds["set-up"] = record::cpu_seconds() - begin;
  if (world.mesh)
    forecast.counts["nodes"] = static_cast<double>(world.mesh->node_count());
  if (scene.growth)
    foretell_crystal(world, triad, forecast);
  else
  {
    if (world.extension)
      foretell_marked_solid(world, forecast);
    else if (world.solid)
      foretell_solid(world, forecast);
    if (world.growth)
    {
      const double steps = scene.clock.end / growth_step_taken(world);
      forecast.counts["growth steps"] = steps;
      forecast.seconds["growth"] = steps * seconds_per_growth_step(world);
    }
    foretell_advection(world, scene.clock.end, forecast);
    forecast.bytes = memory(world);
  }
  // The world has been at work: what it has taken is known, and what it will still take comes on
  // top.
  forecast.resident_bytes =
      record::peak_rss_bytes() + std::max(0., forecast.solver_bytes() - sum(memory(world)));
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
