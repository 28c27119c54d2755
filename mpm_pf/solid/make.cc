#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/reader.h"
#include "scene/value.h"
#include "solid/area_budget.h"
#include "solid/body.h"
#include "solid/energy.h"
#include "solid/seeding.h"
#include "solid/splitting.h"

namespace solid
{
  namespace
  {
    [[noreturn]] void refuse(const scene::SourceLocation &place, const std::string &cause)
    {
      throw scene::BadScene(place.file + ":" + std::to_string(place.line) + ": " + cause);
    }

    Scheme make_scheme(const scene::Scene &scene, const scene::Mpm &mpm)
    {
      Scheme scheme;
      scheme.shape = mpm.shape_function;
      scheme.transfer = mpm.transfer;
      scheme.stress_first = mpm.stress_update == scene::StressUpdate::first;
      scheme.flip_fraction = mpm.transfer == Transfer::pic ? 0. : mpm.flip_fraction;
      for (int k = 0; k < 2; ++k)
        scheme.half_size[k] = 0.5 / mpm.points_per_cell[k];
      scheme.anti_locking = mpm.anti_locking.value_or(scene.solid->locks());
      scheme.pressure_relaxation = mpm.pressure_relaxation;
      scheme.step_fraction = mpm.step_fraction;
      scheme.node_mass_floor = mpm.node_mass_floor;
      return scheme;
    }

    void make_grid(Grid &grid, const scene::Domain &domain)
    {
      const Point dx = domain.spacing();
      if (std::abs(dx[0] - dx[1]) > 1e-9 * dx[0])
        refuse(domain.place, "domain.cells gives cells of " + scene::number_text(dx[0]) + " x " +
                                 scene::number_text(dx[1]) +
                                 "; material points need square ones: choose cells in the "
                                 "proportion of size");
      grid.lower = domain.lower, grid.dx = dx[0], grid.inverse_dx = 1. / dx[0];
      grid.cells = domain.cells;
    }

    // How fast supports and walls drive things; 0 if nothing does.
    double reference_speed(const scene::Scene &scene, const scene::Mpm &mpm,
                           const Supports &supports)
    {
      if (mpm.reference_speed)
        return *mpm.reference_speed;
      double speed = largest_prescribed_speed(supports, scene.clock.end);
      for (const scene::Wall &wall : scene.walls)
        speed = std::max(speed, std::abs(wall.speed));
      if (mpm.mach && !(speed > 0.))
        refuse(mpm.place, "mpm.mach scales the density by the speed of supports or walls, but none "
                          "of them moves; give mpm.reference_speed or leave mach out");
      return speed;
    }
  } // namespace

  Owner make_solid(const scene::Scene &scene, const int threads)
  {
    const scene::Mpm mpm = scene.mpm.value_or(scene::Mpm{});
    Owner owner(new Solid(scene));
    Solid &solid = *owner;
    solid.scheme = make_scheme(scene, mpm);
    solid.light_nodes.before_supports = solid.scheme.shape == Shape::linear;
    make_grid(solid.grid, scene.domain);
    solid.threads = threads;
    // The density only scales the masses, so it may come after all that needs the points.
    solid.material = make_material(*scene.solid, {}, 0.);
    solid.points_per_cell = mpm.points_per_cell;
    solid.points.may_split = mpm.split_points;
    if (!scene.growth) // else activate() makes the points, once something presses on the crystal
    {
      solid.points = make_points(scene, solid.material, mpm.points_per_cell);
      solid.tracers = make_tracers(scene.bodies, scene.domain, 0.5 * solid.grid.dx);
    }
    solid.supports = make_supports(scene, solid.points, solid.tracers);
    place_mirrors(solid.supports, solid.grid);
    solid.loads = make_loads(scene, solid.tracers);
    solid.reference_speed = reference_speed(scene, mpm, solid.supports);
    solid.material = make_material(*scene.solid, mpm.mach, solid.reference_speed);
    solid.loads.true_mass = 1. / solid.material.density_scale;
    for (double &mass : solid.points.mass)
      mass *= solid.material.density_scale;
    square_edges(solid.points, solid.material.density, 0);
    start_energy_account(solid);
    solid.bin = scene::default_bin(scene);
    return owner;
  }

  void Deleter::operator()(Solid *solid) const
  {
    delete solid;
  }

  double time(const Solid &solid)
  {
    return solid.time;
  }

  long steps(const Solid &solid)
  {
    return solid.steps;
  }

  long points(const Solid &solid)
  {
    return static_cast<long>(solid.points.size());
  }

  double largest_speed(const Solid &solid)
  {
    return solid.speed;
  }

  long cells(const Solid &solid)
  {
    return static_cast<long>(solid.grid.nodes.size());
  }

  std::vector<record::Profile::Part> profile(const Solid &solid)
  {
    std::vector<record::Profile::Part> parts;
    for (const auto &[name, part] : solid.spent)
      parts.push_back(part);
    return parts;
  }

  DensityScaling density_scaling(const Solid &solid)
  {
    return {solid.material.density, solid.material.density_scale, solid.material.wave_speed(),
            solid.reference_speed};
  }

  Reaction reaction(const Solid &solid, const std::string &support)
  {
    for (const Support &found : solid.supports.all)
      if (found.name == support)
      {
        const Point force = solid.call_duration > 0.
                                ? Point(found.call_impulse / solid.call_duration)
                                : Point(0., 0.);
        return {found.impulse, force, found.displacement};
      }
    throw std::out_of_range("no support is named \"" + support + "\"");
  }

  std::vector<scene::Polyline> material_outline(const Solid &solid)
  {
    std::vector<scene::Polyline> lines;
    for (const auto &outline : solid.tracers.outlines)
    {
      lines.emplace_back();
      for (const Tracer &tracer : outline)
        lines.back().push_back(tracer.x);
    }
    return lines;
  }
} // namespace solid
