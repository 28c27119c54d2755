#include "inertia.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "scene/geometry.h"
#include "scene/quasi_static.h"

namespace
{
  /// "13 %", "1.5 %".
  std::string percent(const double share)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(std::abs(share) < 0.0995 ? 1 : 0) << 100. * share
         << " %";
    return text.str();
  }

  scene::Edge opposite_of(const scene::Edge side)
  {
    using scene::Edge;
    switch (side)
    {
    case Edge::left:
      return Edge::right;
    case Edge::right:
      return Edge::left;
    case Edge::bottom:
      return Edge::top;
    default:
      return Edge::bottom;
    }
  }
} // namespace

double arm(const World &world, const medium::Wall &wall)
{
  const scene::Edge opposite = opposite_of(wall.side);
  const bool mirrored =
      !world.walls->at(opposite) && world.mesh->side(opposite) == scene::Boundary::symmetry;
  const double span = wall.touched ? wall.span_at_touch : world.scene->domain.size[wall.axis()];
  return mirrored ? span : span / 2.;
}

Inertia inertia(const World &world)
{
  const auto &walls = world.walls->walls;
  // The fastest: one at rest only holds what the other pushes.
  const auto &wall = *std::max_element(walls.begin(), walls.end(),
                                       [](const medium::Wall &a, const medium::Wall &b)
                                       { return a.asked.speed < b.asked.speed; });
  const scene::Edge opposite = opposite_of(wall.side);
  Inertia found;
  found.opposed = world.walls->at(opposite) != nullptr;
  found.arm = arm(world, wall);
  found.numbers = solid::quasi_static(*world.solid, {found.arm, wall.asked.speed});
  return found;
}

std::string verdict_on_inertia(const World &world)
{
  if (!world.solid || !world.walls || medium::compression(*world.walls) == 0.)
    return {};
  const Inertia now = inertia(world);
  const double alone = now.compression(), reached = medium::compression(*world.walls);
  std::string text = "inertia alone takes " + percent(alone) +
                     " of compression to stop an arm; kinetic energy is " +
                     percent(now.numbers.kinetic_to_internal) + " of the internal";
  if (now.opposed)
    text += "; opposite wall forces differ by " + percent(now.numbers.force_imbalance);
  else
    text += "; momentum takes " + percent(now.numbers.momentum_to_force) + " of the wall's force";
  // Twice the travel of one yield stress: beyond it the arm has been brought to speed.
  const double unbalanced =
      now.opposed ? now.numbers.force_imbalance : now.numbers.momentum_to_force;
  const bool still = now.numbers.kinetic_to_internal < 0.05 && unbalanced < 0.1;
  if (still && 2. * alone < reached)
    text += ": quasi-static beyond " + percent(2. * alone);
  else
    text += ": not quasi-static";
  return text;
}

std::string warning_on_scaling(const World &world)
{
  constexpr double enough = 5.;
  const scene::Scene &scene = *world.scene;
  if (!world.solid || !scene.mpm || !scene.mpm->mach || scene.growth)
    return {};
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(), scene::has_initial_velocity))
    return "not quasi-static: mpm.mach scales the density of bodies that start with a velocity, "
           "and with it their momentum; leave mach out";
  const scene::Box box = scene::bounding_box(scene.bodies);
  const double length = (box.upper - box.lower).maxCoeff();
  const solid::DensityScaling scaling = solid::density_scaling(*world.solid);
  const double crossings = scaling.wave_speed * scene.clock.end / length;
  if (crossings >= enough)
    return {};
  std::ostringstream text;
  text.precision(2);
  text << "not quasi-static: mpm.mach multiplies the density by " << scaling.scale
       << ", with which a wave crosses the bodies " << crossings
       << " times in the whole run; lower mach, or give the speed of the loading as "
          "mpm.reference_speed";
  return text.str();
}

std::string warning_on_kinetic_energy(const World &world)
{
  constexpr double bearable = 0.05;
  const scene::Scene &scene = *world.scene;
  if (!world.solid || !scene.mpm || !scene.mpm->mach || scene.growth || world.walls)
    return {};
  const double share = solid::mean_kinetic_share(*world.solid);
  if (share <= bearable)
    return {};
  return "not quasi-static: with the density that mpm.mach scales, kinetic energy is " +
         percent(share) +
         " of what the stresses hold or have dissipated, in the mean over the run; forces ring and "
         "lag, so lower mach (the kinetic energy falls with its square) and compare";
}

std::string warning_on_energy(const World &world)
{
  if (!world.solid)
    return {};
  const auto [transfer, unaccounted] = solid::lost_energy(*world.solid);
  const double missing = transfer + unaccounted;
  if (std::abs(missing) <= 0.1)
    return {};
  const std::string share = percent(std::abs(missing));
  if (missing < 0.)
    return share + " more energy is in the solid than it was ever given: its motion is not to be "
                   "trusted; take a smaller mpm.step_fraction or refine domain.cells";
  return share + " of the energy that the solid was given is lost: " + percent(transfer) +
         " by the numerical dissipation of the transfers between points and grid, " +
         percent(unaccounted) +
         " unaccounted for; what swings or rings dies away, and a force may be off; refine "
         "domain.cells and compare";
}

std::string warning_on_idle_walls(const World &world)
{
  if (!world.walls)
    return {};
  std::string idle;
  for (const medium::Wall &wall : world.walls->walls)
    if (wall.asked.speed > 0. && !wall.started)
      idle += (idle.empty() ? "" : ", ") + solid::wall_name(wall.side);
  if (idle.empty())
    return {};
  return idle + " never started: the front never came within start_distance of it; run longer, or "
                "start it from further away or by start_time";
}

std::string warning_on_missing_walls(const World &world)
{
  if (!world.solid || !world.walls)
    return {};
  std::ostringstream text;
  text.precision(3);
  for (const medium::Wall &wall : world.walls->walls)
    if (wall.started && !wall.touched && wall.travel > 0.)
      text << (text.tellp() > 0 ? ", " : "") << solid::wall_name(wall.side) << " has moved by "
           << wall.travel << " and met nothing";
  const std::string missed = text.str();
  return missed.empty() ? missed
                        : missed + ": the solid was never pressed; raise wall.travel or clock.end, "
                                   "or place the body where the wall comes";
}
