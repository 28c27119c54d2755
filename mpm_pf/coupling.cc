#include "coupling.h"

#include <algorithm>
#include <cmath>

#include "medium/numerical_error.h"
#include "medium/sums.h"
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

  void fill_velocity_ghosts(World &w)
  {
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

  /// The melt's fields end at the walls' new places.
  void update_cuts(World &w)
  {
    medium::update_cuts(*w.walls, *w.mesh, walled_fields(w));
    if (w.orientation && w.orientation->varying())
      melt::refresh(*w.orientation, *w.mesh);
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
  w.melt_moves = w.imposed->moves();
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
  const auto material = copy_velocity(mean, full_mass, *w.mesh, *w.velocity);
  medium::extend_into_liquid<double>(*w.extension, {&w.velocity->x, &w.velocity->y}, w.phase->value,
                                     material, *w.mesh);
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

namespace
{
  /// Where the velocity is the displacement over a whole coupling step, material that is squeezed
  /// out ahead of a fast wall may cross more cells than a scheme can carry at once; so may a jet of
  /// an unsteady motion that is narrower than the nodes at which it was looked at ahead.
  long advection_steps(const World &w, const double dt)
  {
    const auto scheme = w.advection->scheme();
    const double shift = dt * medium::crossing_rate(*w.velocity, *w.mesh);
    const double asked = advection_fraction(*w.scene) * (1. + 1e-6);
    if (w.imposed && (w.imposed->steady() || shift <= asked))
      return 1; // as the scene asks
    const double allowed = 0.9 * medium::largest_shift(scheme);
    // A motion that cannot be meant is left for advect() to refuse.
    constexpr double most = 64.;
    return shift > allowed && shift < most * allowed ? std::lround(std::ceil(shift / allowed)) : 1;
  }

  /// v . grad f is no flux: where v diverges, as its extension into the melt does, and by the error
  /// of the scheme, advection changes the integral of f. In a scene with heat that is booked.
  void advect_field(World &w, AdvectedField &field, const double dt)
  {
    const medium::Cuts cuts = cuts_of(w);
    const auto integral = [&]
    { return w.mesh->spacing.prod() * medium::weighted_sum(field.value, *w.mesh, cuts); };
    const double before = w.heat ? integral() : 0.;
    w.advection->advect(field.value, field.gradients, *w.velocity, dt);
    if (w.heat)
      field.advected += integral() - before;
  }

  void advect_once(World &w, const double dt)
  {
    if (w.phase)
      advect_field(w, *w.phase, dt); // Eq. (1)
    if (w.heat)
      advect_field(w, *w.heat, dt); // Eq. (2)
    if (w.orientation && w.scene->orientation->turning)
    {
      melt::allocate_angle_field(*w.orientation, *w.mesh);
      melt::advance_orientation(*w.orientation, *w.velocity, dt, *w.mesh, *w.advection,
                                w.extension.get()); // Eq. (3)
    }
  }
} // namespace

void advect_melt(World &w, const double dt)
{
  const record::PartTimer timer = record::time_part(w.spent, "advection");
  const long steps = advection_steps(w, dt);
  for (long k = 0; k < steps; ++k)
    advect_once(w, dt / static_cast<double>(steps));
  if (w.extension && w.orientation && w.scene->orientation->turning)
  {
    // By the distance that the velocity was extended with: new solid inherits the front's angle.
    medium::extend_inherited(*w.extension, {&w.orientation->angle}, *w.mesh);
    melt::refresh(*w.orientation, *w.mesh);
  }
  if (w.walls && !w.growth)
    update_cuts(w);
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
