// A crystal and the solid that it becomes: what the first steps of a run cannot show.
#include <algorithm>
#include <cmath>

#include "costs.h"
#include "coupling.h"
#include "forecast_growth.h"
#include "forecast_probes.h"
#include "solid/points.h"
#include "step_count.h"

namespace
{
  /// A square of `cells` cells of the scene's size, nothing in it.
  scene::Scene square_of(const scene::Scene &asked, const int cells)
  {
    scene::Scene square;
    const double cell = asked.domain.spacing()[0];
    square.domain.size = {cells * cell, cells * cell};
    square.domain.cells = {cells, cells};
    square.clock.end = 1.;
    return square;
  }

  /// CPU seconds of a step of both equations for a node near the front: a crystal in a square,
  /// timed. Of the scene itself as it stands, a small seed, most of the time is spent once a step.
  double active_node_seconds(const World &world)
  {
    constexpr int side = 128; // cells
    const scene::Scene &asked = *world.scene;
    scene::Scene square = square_of(asked, side);
    scene::Body seed;
    seed.name = "seed";
    seed.shape = scene::Disc{0.5 * square.domain.size, 0.3 * square.domain.size[0]};
    square.bodies.push_back(seed);
    square.phase_field = asked.phase_field;
    square.growth = asked.growth;
    square.growth->tiles = false;
    square.growth->step.reset(); // one past its limit, forced, costs no more than another
    square.heat = asked.heat;
    if (square.heat)
      square.heat->initial.reset();
    square.noise = asked.noise;
    World grown = build_world(square, 1);
    const double turned = world.orientation ? 1.4 : 1.; // angle field of benchmarks/kernels
    return turned * seconds_per_growth_step(grown) / static_cast<double>(grown.mesh->node_count());
  }

  void forecast_growth(World &world, const GrowthLoad &load, const double triad, Forecast &forecast)
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
    const double each = active_node_seconds(world);
    const double every_step =
        std::max(0., seconds - heat_alone * count(medium::Activity::heat_only) -
                         each * count(medium::Activity::active));
    forecast.counts["growth steps"] = steps;
    forecast.counts["active nodes, mean"] = load.active_nodes;
    forecast.counts["heated nodes, mean"] = load.heated_nodes;
    forecast.seconds["growth"] =
        steps * (every_step + each * load.active_nodes + heat_alone * load.heated_nodes);
  }

  /// Points that will be seeded, and the gradients that the melt's fields carry once they move.
  void forecast_compression_memory(const World &world, const GrowthLoad &load, const double points,
                                   Forecast &forecast)
  {
    const scene::Scene &scene = *world.scene;
    const bool split = scene.mpm && scene.mpm->split_points;
    const double bytes_per_point = static_cast<double>(solid::bytes_per_point(split));
    const double bytes_per_grid_node = 137.;
    // The grid reaches some cells beyond what grows: little round a large crystal, but its arms.
    constexpr double pi = 3.14159265358979, of_arms = 1.2;
    const double rim = load.grows ? 6. : 0.;
    const double cells = load.solid_area / world.mesh->spacing.prod();
    const double disc = pi * std::pow(std::sqrt(cells / pi) + rim, 2);
    forecast.bytes["solid points"] = points * bytes_per_point;
    forecast.bytes["solid grid"] = std::max(of_arms * cells, disc) * bytes_per_grid_node;
    forecast.bytes["solid scratch"] = points * 21.;
    const auto scheme = scene.advection ? scene.advection->scheme : scene::AdvectionScheme::cip;
    const double carried = scheme == scene::AdvectionScheme::cip           ? 4.
                           : scheme == scene::AdvectionScheme::cip_hermite ? 5.
                                                                           : 1.;
    const double field = static_cast<double>(world.phase->value.bytes());
    forecast.bytes["phase field"] = carried * field;
    if (world.heat)
      forecast.bytes["heat"] = carried * field;
    if (world.orientation && scene.orientation->turning)
      forecast.bytes["orientation"] = (2. + carried) * field; // cosine and sine beside the angle
    forecast.bytes["advection"] = std::max(0., carried - 1.) * field;
  }

  /// CPU seconds of a point's step with the scene's material and settings: a block of them, timed.
  double point_step_seconds(const scene::Scene &asked)
  {
    constexpr int side = 32; // cells
    scene::Scene block = square_of(asked, side + 8);
    const double cell = asked.domain.spacing()[0];
    scene::Body body;
    body.name = "block";
    body.shape = scene::Rectangle{{4. * cell, 4. * cell}, {side * cell, side * cell}};
    block.bodies.push_back(body);
    block.solid = asked.solid;
    block.mpm = asked.mpm;
    if (block.mpm)
      block.mpm->mach.reset();
    const auto points = solid::make_solid(block);
    const double step = solid::stable_step(*points);
    return seconds_of([&] { solid::advance(*points, step); }, probe_budget_s, probe_calls) /
           static_cast<double>(solid::points(*points));
  }

  /// A solid that a wall finds when it arrives: points are seeded over the crystal, then the solid,
  /// its velocity's extension and the melt's advection work until the walls have travelled. What
  /// a node costs, in steps of a point, is that of the compressed dendrite.
  void forecast_compression(const World &world, const GrowthLoad &load, Forecast &forecast)
  {
    constexpr double carried_node = 0.3, extended_node = 6.,
                     distance_part = 0.5; // of extended_node
    const scene::Scene &scene = *world.scene;
    const scene::Mpm mpm = scene.mpm.value_or(scene::Mpm{});
    const double cell = world.mesh->spacing.prod(), duration = load.end - load.pressed_from;
    const double points = load.solid_area / cell * mpm.points_per_cell[0] * mpm.points_per_cell[1];
    const double nodes = static_cast<double>(world.mesh->node_count());
    const StepCount count = count_steps(world, load.pressed_from, load.end, coupling_step(world),
                                        solid::stable_step(*world.solid));
    const double steps = count.substeps, couplings = count.couplings;
    const double coupling = duration / couplings; // in the mean
    const double fields = 1. + (world.heat ? 1. : 0.) + (world.orientation ? 1. : 0.);
    forecast.counts["points"] = points;
    forecast.counts["steps"] = steps;
    forecast.counts["coupling steps"] = couplings;
    const double point_step = point_step_seconds(scene);
    forecast.seconds["solid"] = steps * points * point_step;
    const double apart = steps_between_advections(world, shift_of_a_step(world, coupling));
    if (world.uncarried)
      forecast.counts["advections"] = couplings / apart;
    const double measured = 1. / std::min(world.extension->interval, world.extension->map_interval);
    forecast.seconds["advection"] =
        couplings * nodes * point_step *
        (fields * carried_node / apart + extended_node * (1. - distance_part * (1. - measured)));
    forecast_compression_memory(world, load, points, forecast);
  }
} // namespace

void forecast_crystal(World &world, const double triad, Forecast &forecast)
{
  const GrowthLoad load = growth_load(world);
  forecast_growth(world, load, triad, forecast);
  forecast_advection(world, load.end, forecast);
  forecast.bytes = memory(world);
  if (world.solid && load.pressed_from < load.end) // else no wall ever meets it: no point is seeded
    forecast_compression(world, load, forecast);
}
