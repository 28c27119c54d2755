#include "coupling.h"

#include <algorithm>
#include <cmath>

#include "medium/numerical_error.h"
#include "record/stopwatch.h"
#include "scene/value.h"
#include "solid/growing.h"
#include "solid/moving_walls.h"

namespace
{
  /// Nodes with less than this part of a full cell's mass count as liquid: their velocity rests on
  /// the tail of a shape function.
  constexpr double least_mass = 0.1;

  solid::Crystal crystal(const World &w)
  {
    std::optional<scene::Box> between;
    if (w.walls)
      between = medium::active_box(w.walls->cuts, *w.mesh);
    return {w.phase->value, *w.mesh, between};
  }

  bool grows_points(const World &w)
  {
    return w.solid && w.growth && w.scene->growth;
  }

  bool is_loaded(const World &w)
  {
    return !w.walls ||
           std::any_of(w.walls->walls.begin(), w.walls->walls.end(),
                       [](const medium::Wall &wall) { return wall.touched.has_value(); });
  }

  std::vector<solid::WallMotion> motions(const medium::Walls &walls)
  {
    std::vector<solid::WallMotion> all;
    for (const medium::Wall &wall : walls.walls)
      all.push_back({wall.side, wall.position, wall.velocity});
    return all;
  }

  /// A wall that pushes has touched, whether or not a front was seen to arrive there.
  void note_contacts(World &w, const double time)
  {
    if (!w.walls)
      return;
    for (medium::Wall &wall : w.walls->walls)
      if (!wall.touched &&
          !solid::reaction(*w.solid, solid::wall_name(wall.side)).impulse.isZero(0.))
        medium::record_contact(wall, *w.walls, *w.mesh, time);
  }

  /// The solid's nodal velocity on the mesh; 1 in the result where it rests on enough mass.
  medium::Field<unsigned char> copy_velocity(const solid::NodalVelocity &mean,
                                             const double full_mass, const medium::Mesh &mesh,
                                             medium::Velocity &velocity)
  {
    medium::Field<unsigned char> material(mesh);
    std::size_t n = 0;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i, ++n)
      {
        velocity.x(i, j) = mean.x[n];
        velocity.y(i, j) = mean.y[n];
        material(i, j) = mean.mass[n] > least_mass * full_mass * mesh.weight(i, j);
      }
    return material;
  }

  /// Nothing crosses a symmetry side; lines fitted to one half of what is symmetric do not know.
  void vanish_across_symmetry_sides(medium::Velocity &velocity, const medium::Mesh &mesh)
  {
    const auto symmetric = [&](const scene::Edge side)
    { return mesh.side(side) == scene::Boundary::symmetry; };
    const int nx = mesh.nodes[0], ny = mesh.nodes[1];
    for (const bool high : {false, true})
    {
      if (symmetric(high ? scene::Edge::right : scene::Edge::left))
        for (int j = 0; j < ny; ++j)
          velocity.x(high ? nx - 1 : 0, j) = 0.;
      if (symmetric(high ? scene::Edge::top : scene::Edge::bottom))
        for (int i = 0; i < nx; ++i)
          velocity.y(i, high ? ny - 1 : 0) = 0.;
    }
  }

  void fill_velocity_ghosts(World &w)
  {
    vanish_across_symmetry_sides(*w.velocity, *w.mesh);
    medium::fill_ghosts(w.velocity->x, *w.mesh, medium::Parity::odd_in_x);
    medium::fill_ghosts(w.velocity->y, *w.mesh, medium::Parity::odd_in_y);
    if (w.walls)
      medium::fill_behind(*w.velocity, *w.walls, *w.mesh);
  }

  std::vector<medium::WalledField> walled_fields(World &w)
  {
    std::vector<medium::WalledField> fields;
    if (w.phase)
      fields.push_back({&w.phase->value, &w.phase->gradients, &w.walls->swept_phase});
    if (w.heat)
      fields.push_back({&w.heat->value, &w.heat->gradients, &w.walls->swept_heat});
    if (w.orientation && w.orientation->varying())
      fields.push_back({&w.orientation->angle, &w.orientation->gradients, nullptr});
    return fields;
  }

  void sweep(World &w, const double dt)
  {
    const long steps = std::max(1L, std::lround(std::ceil(dt / growth_step(w) * (1. - 1e-9))));
    // Without [growth] phi is a marker that is only carried, and the sweep is of heat alone.
    try
    {
      w.growth->advance({w.scene->growth ? &w.phase->value : nullptr,
                         w.heat ? &w.heat->value : nullptr, w.orientation.get(), w.noise.get(),
                         w.walls ? &w.walls->cuts : nullptr},
                        dt / static_cast<double>(steps), steps);
    }
    catch (const medium::NumericalError &error) // which knows its steps, not the time
    {
      throw medium::NumericalError("from time " + scene::number_text(w.time) + " on, " +
                                   error.what());
    }
  }
} // namespace

void update_cuts(World &w)
{
  medium::update_cuts(*w.walls, *w.mesh, walled_fields(w));
  if (w.orientation && w.orientation->varying())
    melt::refresh(*w.orientation, *w.mesh);
}

bool coupled(const World &w)
{
  return w.extension != nullptr;
}

void move_walls(World &w, const double dt)
{
  const record::PartTimer timer = record::time_part(w.spent, "walls");
  if (w.phase)
    medium::start_walls(*w.walls, w.phase->value, *w.mesh, w.time,
                        w.solid && !w.scene->growth ? medium::Contact::push
                                                    : medium::Contact::front);
  else
    medium::start_walls(*w.walls, w.time);
  medium::move(*w.walls, w.time, dt, *w.mesh); // Sec. 3, cut cells [28,29]
}

void impose(World &w, const double dt)
{
  const record::PartTimer timer = record::time_part(w.spent, "imposed motion");
  w.imposed->evaluate(w.time + dt / 2, *w.mesh, *w.velocity);
  if (w.walls)
    medium::fill_behind(*w.velocity, *w.walls, *w.mesh);
  w.melt_moves = w.imposed->moves() || (w.uncarried && w.uncarried->steps > 0);
}

void activate_solid(World &w)
{
  if (grows_points(w) && !solid::active(*w.solid) && is_loaded(w))
  {
    solid::activate(*w.solid, crystal(w), w.time);
    if (w.time == 0. && !w.walls)
      solid::set_initial_state(*w.solid, w.scene->bodies);
  }
}

void move_solid(World &w, const double dt)
{
  activate_solid(w);
  if (grows_points(w) && !solid::active(*w.solid))
    return;
  if (w.walls)
    solid::set_wall_motions(*w.solid, motions(*w.walls), dt);
  solid::NodalVelocity mean;
  {
    const record::PartTimer timer = record::time_part(w.spent, "solid");
    solid::advance(*w.solid, dt, &mean);
    note_contacts(w, w.time + dt);
  }
  const record::PartTimer timer = record::time_part(w.spent, "extension");
  const double full_mass =
      solid::density_scaling(*w.solid).density * w.mesh->spacing[0] * w.mesh->spacing[1];
  auto material = copy_velocity(mean, full_mass, *w.mesh, *w.velocity);
  medium::extend_into_liquid<double>(*w.extension, {&w.velocity->x, &w.velocity->y}, w.phase->value,
                                     material, *w.mesh);
  if (w.uncarried)
    w.uncarried->material.swap(material);
  fill_velocity_ghosts(w);
  w.melt_moves = true;
}

void move_solid_alone(World &w, const double dt)
{
  if (w.walls)
    solid::set_wall_motions(*w.solid, motions(*w.walls), dt);
  const record::PartTimer timer = record::time_part(w.spent, "solid");
  solid::advance(*w.solid, dt);
  note_contacts(w, w.time + dt);
}

void grow(World &w, const double dt)
{
  if (w.walls)
    update_cuts(w);
  if (grows_points(w))
  {
    const record::PartTimer timer = record::time_part(w.spent, "seeding");
    solid::begin_growth(*w.solid, crystal(w));
  }
  {
    const record::PartTimer timer = record::time_part(w.spent, w.scene->growth ? "growth" : "heat");
    sweep(w, dt);
  }
  if (w.walls && w.phase)
    medium::fill_behind(w.phase->value, w.walls->cuts, *w.mesh);
  if (grows_points(w))
  {
    const record::PartTimer timer = record::time_part(w.spent, "seeding");
    solid::seed_new_points(*w.solid, crystal(w));
  }
}
