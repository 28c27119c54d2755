#include "world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "capacity.h"
#include "medium/sums.h"
#include "ramps.h"
#include "scene/interface_distance.h"
#include "scene/value.h"

namespace
{
  using medium::Field;
  using medium::Mesh;

  /// The profile is flat to 1e-12 beyond 20 W; chords of 0.2 W leave 1e-3 W on a seed of 5 W.
  scene::InterfaceDistance distance_to_interface(const scene::Scene &scene)
  {
    const double width = scene.phase_field->width;
    return {scene.bodies, scene.domain, 20. * width, 0.2 * width};
  }

  /// phi = tanh(d / (sqrt(2) W)), d the signed distance to the bodies: the equilibrium profile.
  Field<double> phase_of_bodies(const scene::Scene &scene, const Mesh &mesh,
                                const scene::InterfaceDistance &distance)
  {
    Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        phi(i, j) =
            std::tanh(distance(mesh.position(i, j)) / (std::sqrt(2.) * scene.phase_field->width));
    medium::fill_ghosts(phi, mesh);
    return phi;
  }

  /// Gradient of that profile along `axis`: (1 - phi^2)/(sqrt(2) W) times the slope of the
  /// distance.
  Field<double> phase_gradient(const scene::Scene &scene, const Mesh &mesh,
                               const scene::InterfaceDistance &distance, const int axis,
                               const Field<double> &phi)
  {
    Field<double> gradient(mesh);
    const double small = 1e-5 * mesh.spacing[axis];
    scene::Point shift = scene::Point::Zero();
    shift[axis] = small;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const scene::Point x = mesh.position(i, j);
        const double slope = (distance(x + shift) - distance(x - shift)) / (2 * small);
        gradient(i, j) =
            (1 - phi(i, j) * phi(i, j)) / (std::sqrt(2.) * scene.phase_field->width) * slope;
      }
    medium::fill_ghosts(gradient, mesh,
                        axis == 0 ? medium::Parity::odd_in_x : medium::Parity::odd_in_y);
    return gradient;
  }

  Field<double> initial_temperature(const scene::Heat &heat, const Mesh &mesh)
  {
    Field<double> theta(mesh, -heat.undercooling);
    if (heat.initial)
    {
      const scene::Function initial(*heat.initial);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          theta(i, j) = initial({mesh.position(i, j), mesh.position(i, j), 0.});
    }
    medium::fill_ghosts(theta, mesh);
    return theta;
  }

  void build_growth(World &world, const bool force)
  {
    const scene::Scene &scene = *world.scene;
    melt::GrowthOptions options;
    melt::Law law;
    if (scene.growth)
    {
      options = {scene.growth->laplacian, scene.growth->precision, scene.growth->tiles, true,
                 force};
      law = melt::make_law(*scene.phase_field, *scene.growth, scene.heat ? &*scene.heat : nullptr);
    }
    else
    {
      options.laplacian = scene::Laplacian::five_point;
      options.phase = false;
      options.force = force;
      law.diffusivity = scene.heat->diffusivity;
    }
    double undercooling = scene.heat ? std::abs(scene.heat->undercooling) : 0.;
    if (scene.heat && scene.heat->initial)
    {
      const medium::Statistics theta = medium::statistics_of(world.heat->value, *world.mesh);
      undercooling = std::max({undercooling, std::abs(theta.min), std::abs(theta.max)});
    }
    world.growth = std::make_unique<melt::Growth>(*world.mesh, law, options, undercooling);
    const double limit = world.growth->step_limit();
    if (scene.growth && scene.growth->step && *scene.growth->step > limit && !force)
      throw scene::BadScene(
          scene.growth->place.file + ":" + std::to_string(scene.growth->place.line) +
          ": growth.step = " + scene::number_text(*scene.growth->step) +
          " exceeds the limit of the explicit scheme, " + scene::number_text(limit) +
          "; shorten it or leave it out (--force shows it fail)");
    if (scene.noise)
      world.noise = std::make_unique<melt::Noise>(
          *world.mesh, melt::Noise::Options{scene.noise->strength, law.diffusivity,
                                            scene.noise->seed, scene.noise->mirrored});
  }

  /// `distance`: to the interface of the phase field, if there is one.
  void build_motion(World &world, const std::optional<scene::InterfaceDistance> &distance)
  {
    const scene::Scene &scene = *world.scene;
    const auto scheme = scene.advection ? scene.advection->scheme : scene::AdvectionScheme::cip;
    world.velocity = std::make_unique<medium::Velocity>(*world.mesh);
    world.advection = std::make_unique<medium::Advection>(*world.mesh, scheme);
    if (scene.advection && scene.advection->interval > 1)
      world.uncarried = std::make_unique<Uncarried>(*world.mesh, scene.advection->interval,
                                                    scene.solid.has_value());
    if (world.phase && (!scene.advection || scene.advection->analytic_gradients))
      world.advection->start(world.phase->value, world.phase->gradients,
                             phase_gradient(scene, *world.mesh, *distance, 0, world.phase->value),
                             phase_gradient(scene, *world.mesh, *distance, 1, world.phase->value));
    if (scene.imposed)
    {
      world.imposed = std::make_unique<Imposed>(*scene.imposed);
      world.imposed->evaluate(0., *world.mesh, *world.velocity);
    }
  }
} // namespace

World build_world(const scene::Scene &scene, const int threads, const bool force)
{
  refuse_more_than_memory(scene, least_bytes(scene));
  World world;
  world.scene = &scene;
  world.threads = threads;
  if (scene.phase_field || scene.heat || !scene.walls.empty())
    world.mesh = std::make_unique<Mesh>(medium::make_mesh(scene.domain));
  std::optional<scene::InterfaceDistance> distance;
  if (scene.phase_field)
  {
    distance = distance_to_interface(scene);
    world.phase = std::make_unique<AdvectedField>();
    world.phase->value = phase_of_bodies(scene, *world.mesh, *distance);
  }
  if (scene.heat)
  {
    world.heat = std::make_unique<AdvectedField>();
    world.heat->value = initial_temperature(*scene.heat, *world.mesh);
  }
  if (scene.orientation)
    world.orientation = std::make_unique<melt::Orientation>(
        melt::make_orientation(scene.orientation->angle_degrees));
  if (scene.growth || scene.heat)
    build_growth(world, force);
  if (scene.solid)
    world.solid = solid::make_solid(scene, threads);
  if (!scene.walls.empty())
    world.walls = std::make_unique<medium::Walls>(medium::make_walls(scene.walls, *world.mesh));
  if (world.walls && world.solid)
    choose_wall_ramps(world);
  if (scene.imposed || (scene.solid && scene.phase_field))
    build_motion(world, distance);
  if (scene.solid && scene.phase_field)
    world.extension = std::make_unique<medium::Extension>(
        *world.mesh, scene.extension.value_or(scene::Extension{}), scene.phase_field->width);
  return world;
}

bool finished(const World &world)
{
  const auto moves = [](const medium::Wall &wall) { return wall.asked.travel > 0.; };
  const auto travelled = [](const medium::Wall &wall)
  { return wall.travel >= wall.asked.travel * (1. - 1e-12); };
  if (world.time >= world.scene->clock.end * (1. - 1e-12))
    return true;
  if (!world.walls)
    return false;
  const auto &walls = world.walls->walls;
  return std::any_of(walls.begin(), walls.end(), moves) &&
         std::all_of(walls.begin(), walls.end(), travelled);
}

namespace
{
  /// When a wall will have travelled; `end` where that depends on a front that it waits for.
  double expected_stop(const medium::Wall &wall, const double now, const double end)
  {
    const scene::Wall &asked = wall.asked;
    if (wall.started)
      return now + (asked.travel - wall.travel) / asked.speed;
    if (!asked.start_time)
      return end;
    const double ramps = 0.5 * (asked.ramp.value_or(0.) + asked.contact_ramp.value_or(0.));
    return *asked.start_time + ramps + asked.travel / asked.speed;
  }
} // namespace

double expected_end(const World &world)
{
  const double end = world.scene->clock.end;
  double stop = 0.; // of the walls
  if (world.walls)
    for (const medium::Wall &wall : world.walls->walls)
      if (wall.asked.travel > 0.)
        stop = std::max(stop, expected_stop(wall, world.time, end));
  return stop > 0. ? std::min(stop, end) : end;
}

double advection_fraction(const scene::Scene &scene)
{
  return scene.advection.value_or(scene::Advection{}).step_fraction;
}

medium::Cuts cuts_of(const World &world)
{
  return world.walls ? world.walls->cuts : medium::Cuts{};
}

double growth_step(const World &world)
{
  const auto &growth = world.scene->growth;
  if (growth && growth->step)
    return *growth->step;
  return (growth ? growth->step_fraction : 0.8) * world.growth->step_limit();
}

namespace
{
  /// Longest step over which the solid's motion may be taken as a whole: the melt's fields are
  /// carried by its mean, `fraction` of a cell at most.
  double motion_limit(const World &world, const double fraction)
  {
    const double reference = solid::density_scaling(*world.solid).reference_speed;
    const double present = solid::largest_speed(*world.solid);
    const double room = fraction * world.scene->domain.spacing()[0];
    // Points swing about the speed at which they are driven, and are squeezed out ahead of it; what
    // is faster than that moves by itself.
    constexpr double swing = 3.;
    // A solid that nothing drives may be as fast as a wave lets it within some cells of its way:
    // 64 steps, at most 1 % of the speed of sound each half a cell long.
    constexpr double steps_from_rest = 64.;
    double limit = std::numeric_limits<double>::infinity();
    if (present > swing * reference)
      limit = room / present;
    else if (reference > 0.)
      limit = room / reference;
    const bool accelerates = !world.scene->growth || world.scene->body_force;
    if (accelerates && solid::points(*world.solid) > 0 &&
        (reference <= 0. || present > swing * reference))
      limit = std::min(limit, steps_from_rest * solid::stable_step(*world.solid));
    return limit;
  }
} // namespace

double coupling_step(const World &world)
{
  const scene::Scene &scene = *world.scene;
  double step = std::numeric_limits<double>::infinity();
  if (scene.clock.step)
    step = *scene.clock.step;
  // Coming back now and then lets the run be watched, interrupted and checkpointed.
  constexpr double substeps_between_looks = 512.;
  // A front that walls or seeding wait for may move a fraction of a cell only.
  constexpr double substeps_between_couplings = 32.;
  const double fraction = advection_fraction(scene);
  if (world.solid && !world.extension)
    step = std::min(step, substeps_between_looks * solid::stable_step(*world.solid));
  if (world.growth)
    step = std::min(
        step, (world.walls || world.solid ? substeps_between_couplings : substeps_between_looks) *
                  growth_step(world));
  if (world.imposed)
    step = world.imposed->step({world.time, step, scene.clock.end, fraction}, *world.mesh);
  if (world.walls)
    step = std::min(step, medium::step_limit(*world.walls, *world.mesh, fraction));
  if (world.extension)
    step = std::min(step, motion_limit(world, fraction));
  return step;
}
