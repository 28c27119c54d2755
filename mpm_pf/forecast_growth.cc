#include "forecast_growth.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/special_functions.h"

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /// The crystal's arms along the four directions, in lengths of the scene.
  struct Arms
  {
    double seed = 0.;                // radius it starts from
    std::array<double, 4> room{};    // from its centre to the sides, by scene::Edge
    std::array<double, 4> visible{}; // 1 if the arm lies in the domain, 0 if beyond a side
    double speed = 0., gap = 0.;     // of the tips; in which they stop before a side
    double spread = 0.;              // of a round crystal: its radius squared per time
    double reach(const std::size_t side, const double time) const
    {
      const double grown = std::max(seed + speed * time, std::sqrt(seed * seed + spread * time));
      return visible[side] * std::min(grown, std::max(seed, room[side] - gap));
    }
  };

  /// Radius squared over time of F. C. Frank's disc (1950), R^2 = 4 D s t with
  /// s exp(s) E1(s) = undercooling: a crystal without anisotropy has no tips and grows like that.
  double spread_of_disc(const scene::Scene &scene)
  {
    double low = 1e-9, high = 1e2;
    for (int k = 0; k < 100; ++k)
    {
      const double s = std::sqrt(low * high);
      const double supplied = std::exp(s) * s * scene::exponential_integral(s);
      (supplied < std::min(0.95, scene.heat->undercooling) ? low : high) = s;
    }
    return 4. * scene.heat->diffusivity * low;
  }

  Arms arms_of(const World &world)
  {
    const scene::Scene &scene = *world.scene;
    const scene::Box body = scene::bounding_box(scene.bodies);
    const scene::Point centre = 0.5 * (body.lower + body.upper);
    Arms arms;
    arms.seed = 0.5 * (body.upper - body.lower).maxCoeff();
    arms.speed = tip_velocity(scene);
    constexpr double least_anisotropy = 5e-3;
    if (arms.speed > 0. && !scene.heat->initial && scene.growth->anisotropy < least_anisotropy)
      arms.spread = spread_of_disc(scene);
    // Heat piles up before an adiabatic side; the tip all but stalls at half a boundary layer.
    if (arms.speed > 0. && arms.spread == 0.)
      arms.gap = 0.55 * scene.heat->diffusivity / arms.speed;
    const scene::Point lower = scene.domain.lower, upper = scene.domain.upper();
    arms.room = {centre[0] - lower[0], upper[0] - centre[0], centre[1] - lower[1],
                 upper[1] - centre[1]};
    for (std::size_t side = 0; side < 4; ++side)
      arms.visible[side] = arms.room[side] > 0.25 * arms.seed ? 1. : 0.;
    return arms;
  }

  /// Length of the plane fronts of a layer that reaches from one side of the domain to the other; 0
  /// where none does.
  double layer_front_length(const scene::Scene &scene)
  {
    const scene::Box body = scene::bounding_box(scene.bodies);
    const scene::Point lower = scene.domain.lower, upper = scene.domain.upper();
    const double rounding = 1e-9 * scene.domain.size.maxCoeff();
    for (const int along : {0, 1})
    {
      const int across = 1 - along;
      const double fronts = (body.lower[across] > lower[across] + rounding ? 1. : 0.) +
                            (body.upper[across] < upper[across] - rounding ? 1. : 0.);
      if (body.lower[along] < lower[along] + rounding &&
          body.upper[along] > upper[along] - rounding)
        return fronts * scene.domain.size[along];
    }
    return 0.;
  }

  /// Length of phi = 0: each quarter has the sides of two half arms, rounder at first.
  double interface_length(const Arms &arms, const double time)
  {
    double length = 0.;
    for (const std::size_t x : {0u, 1u})
      for (const std::size_t y : {2u, 3u})
        if (arms.visible[x] > 0. && arms.visible[y] > 0.)
        {
          const double arm = arms.reach(x, time) + arms.reach(y, time);
          length += 0.8 * arm + 0.47 * std::min(arm, 2. * arms.seed);
        }
    return length;
  }

  /// Solid part of the rectangles between two arms: a disc's at first, slimmer as the arms grow
  /// out, the more so the stronger the anisotropy; no more than the undercooling can freeze.
  double solid_area(const scene::Scene &scene, const Arms &arms, const double time)
  {
    const double strength = scene.growth->anisotropy / 0.05;
    // With noise an arm of many radii of its parabola is full of side branches: at eps = 0.06 and
    // 33 radii 0.29 of the rectangles is solid; 13 radii at 0.06 and 17 at 0.05 show none.
    constexpr double radii_to_branch = 25.;
    const double tip = tip_radius(scene);
    double area = 0.;
    for (const std::size_t x : {0u, 1u})
      for (const std::size_t y : {2u, 3u})
      {
        const double a = arms.reach(x, time), b = arms.reach(y, time);
        const double grown = (std::min(a, b) - arms.seed) / arms.seed;
        // Weak anisotropy makes arms late: at eps = 0.015 the crystal fills 0.66 and 0.54 of the
        // square between two at 8 and 13 seed radii, 0.55 of the rectangle when pressed.
        const double slimmed = grown / 14. * std::min(1., 0.78 * std::pow(strength, 3) * grown) *
                               std::max(1., strength * strength);
        const bool branched = scene.noise && tip > 0. && std::min(a, b) > radii_to_branch * tip;
        area += std::max(branched ? 0.29 : 0.15, pi / 4. * std::exp(-slimmed)) * a * b;
      }
    const double freezable = scene.heat ? std::min(1., scene.heat->undercooling) : 1.;
    return std::min(area, freezable * scene.domain.size.prod());
  }

  /// Nodes across the strip of active tiles: phi comes to rest in its wells, to the sweep's
  /// flatness, at some 17 (float: 9) widths from the front, and a tile works where a neighbour
  /// does.
  double strip_width(const World &world)
  {
    constexpr double tiles = 52.; // two of mean width at any angle, and the halves they overlap
    const bool whole = world.scene->growth->precision == scene::Precision::double_precision;
    return tiles +
           2. * (whole ? 17. : 9.) * world.scene->phase_field->width / world.mesh->spacing[0];
  }

  /// Area within the reach of the heat: theta counts as resting only where it is one constant to
  /// the last bit, which diffusion's tail leaves behind at about 12 sqrt(D t).
  double heated_area(const World &world, const Arms &arms, const double time)
  {
    const scene::Scene &scene = *world.scene;
    const double bits = scene.growth->precision == scene::Precision::double_precision ? 12. : 8.;
    const double tail = scene.heat ? bits * std::sqrt(scene.heat->diffusivity * time) : 0.;
    double width = 0., height = 0.;
    for (const std::size_t side : {0u, 1u})
      width += std::min(std::max(0., arms.room[side]), arms.reach(side, time) + tail);
    for (const std::size_t side : {2u, 3u})
      height += std::min(std::max(0., arms.room[side]), arms.reach(side, time) + tail);
    return width * height;
  }

  /// Of a wall and a tip that approach each other. The tip slows down in the heat that piles up
  /// between them and comes no further than some three interface widths (measured: 2.4 in 27 tau0
  /// at eps = 0.05, 3.2 in 240 tau0 at eps = 0.015).
  double time_to_meet(const World &world, const double tip, const double wall, const double gap)
  {
    const double most = 3. * world.scene->phase_field->width;
    double time = gap / (wall + tip);
    for (int k = 0; k < 50; ++k)
      time = std::max(0., gap - most * (1. - std::exp(-tip * time / most))) / wall;
    return time;
  }

  void let_walls_end(const World &world, const Arms &arms, GrowthLoad &load)
  {
    if (!world.walls)
      return;
    for (const medium::Wall &one : world.walls->walls)
    {
      const scene::Wall &wall = one.asked;
      if (wall.speed <= 0.)
        continue;
      const double room = arms.room[static_cast<std::size_t>(wall.side)];
      const double start =
          wall.start_time   ? *wall.start_time
          : arms.speed > 0. ? std::max(0., (room - *wall.start_distance - arms.seed) / arms.speed)
                            : load.end;
      const double gap = wall.start_time ? std::max(0., room - arms.seed - arms.speed * start)
                                         : *wall.start_distance;
      const double meet =
          start + 0.5 * wall.ramp.value_or(0.) + time_to_meet(world, arms.speed, wall.speed, gap);
      load.pressed_from = std::min(load.pressed_from, meet);
      load.end =
          std::min(load.end, start + 0.5 * wall.ramp.value_or(0.) + wall.travel / wall.speed);
    }
    load.pressed_from = std::min(load.pressed_from, load.end);
  }
} // namespace

double peclet_number(const double undercooling)
{
  if (undercooling <= 0.)
    return 0.;
  double low = 0., high = 1e3;
  for (int k = 0; k < 100; ++k)
  {
    const double pe = 0.5 * (low + high);
    const double supplied =
        pe > 500. ? 1. : std::sqrt(pi * pe) * std::exp(pe) * std::erfc(std::sqrt(pe));
    (supplied < undercooling ? low : high) = pe;
  }
  return 0.5 * (low + high);
}

double tip_velocity(const scene::Scene &scene)
{
  if (!scene.growth || !scene.heat || scene.heat->undercooling <= 0.)
    return 0.;
  const double pe = peclet_number(std::min(0.95, scene.heat->undercooling));
  const double sigma = 2.2 * std::pow(std::max(scene.growth->anisotropy, 0.005), 0.95);
  return 2. * sigma * pe * pe * scene.heat->diffusivity / scene.growth->capillary_length;
}

double tip_radius(const scene::Scene &scene)
{
  const double speed = tip_velocity(scene);
  if (speed <= 0.)
    return 0.;
  const double pe = peclet_number(std::min(0.95, scene.heat->undercooling));
  return 2. * pe * scene.heat->diffusivity / speed;
}

GrowthLoad growth_load(const World &world)
{
  const scene::Scene &scene = *world.scene;
  const Arms arms = arms_of(world);
  GrowthLoad load;
  load.end = scene.clock.end;
  load.pressed_from = scene.walls.empty() ? 0. : load.end; // without walls nothing waits for one
  let_walls_end(world, arms, load);
  load.solid_area = solid_area(scene, arms, load.end); // points are seeded as it grows on
  load.grows = load.solid_area > 1.02 * solid_area(scene, arms, 0.);

  const double strip = strip_width(world);
  const double cell = world.mesh->spacing[0];
  const double nodes = static_cast<double>(world.mesh->node_count());
  const double layer = layer_front_length(scene);
  constexpr int samples = 40;
  for (int k = 0; k < samples; ++k)
  {
    const double time = (k + 0.5) / samples * load.end;
    const double length = layer > 0. ? layer : interface_length(arms, time);
    const double active = scene.growth->tiles ? std::min(nodes, strip * length / cell) : nodes;
    const double heated =
        scene.growth->tiles && !world.noise
            ? std::min(nodes, heated_area(world, arms, time) / (cell * world.mesh->spacing[1]))
            : nodes;
    load.active_nodes += active / samples;
    load.heated_nodes += std::max(0., heated - active) / samples;
  }
  return load;
}
