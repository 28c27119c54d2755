// v . grad of Eqs. (1)-(3): the melt's fields follow the motion, at every coupling step or all of
// the way of several at once.
#include <algorithm>
#include <cmath>

#include "coupling.h"
#include "medium/sums.h"
#include "record/stopwatch.h"

namespace
{
  /// Cells that a scheme is let carry at once: some way below what it can bear.
  double allowed_shift(const World &w)
  {
    return 0.9 * medium::largest_shift(w.advection->scheme());
  }

  /// Where the velocity is the displacement over a whole coupling step, material that is squeezed
  /// out ahead of a fast wall may cross more cells than a scheme can carry at once; so may a jet of
  /// an unsteady motion that is narrower than the nodes at which it was looked at ahead.
  long advection_steps(const World &w, const medium::Velocity &velocity, const double dt)
  {
    const double shift = dt * medium::crossing_rate(velocity, *w.mesh);
    const double asked = advection_fraction(*w.scene) * (1. + 1e-6);
    if (w.imposed && (w.imposed->steady() || shift <= asked))
      return 1; // as the scene asks
    const double allowed = allowed_shift(w);
    // A motion that cannot be meant is left for advect() to refuse.
    constexpr double most = 64.;
    return shift > allowed && shift < most * allowed ? std::lround(std::ceil(shift / allowed)) : 1;
  }

  /// v . grad f is no flux: where v diverges, as its extension into the melt does, and by the error
  /// of the scheme, advection changes the integral of f. In a scene with heat that is booked.
  void advect_field(World &w, AdvectedField &field, const medium::Velocity &velocity,
                    const double dt)
  {
    const medium::Cuts cuts = cuts_of(w);
    const auto integral = [&]
    { return w.mesh->spacing.prod() * medium::weighted_sum(field.value, *w.mesh, cuts); };
    const double before = w.heat ? integral() : 0.;
    w.advection->advect(field.value, field.gradients, velocity, dt);
    if (w.heat)
      field.advected += integral() - before;
  }

  void advect_once(World &w, const medium::Velocity &velocity, const double dt)
  {
    if (w.phase)
      advect_field(w, *w.phase, velocity, dt); // Eq. (1)
    if (w.heat)
      advect_field(w, *w.heat, velocity, dt); // Eq. (2)
    if (w.orientation && w.scene->orientation->turning)
    {
      const record::PartTimer timer = record::time_part(w.spent, "orientation");
      melt::allocate_angle_field(*w.orientation, *w.mesh);
      melt::advance_orientation(*w.orientation, velocity, dt, *w.mesh, *w.advection,
                                w.extension.get()); // Eq. (3)
    }
  }

  void carry(World &w, const medium::Velocity &velocity, const double dt)
  {
    const record::PartTimer timer = record::time_part(w.spent, "advection");
    const long steps = advection_steps(w, velocity, dt);
    for (long k = 0; k < steps; ++k)
      advect_once(w, velocity, dt / static_cast<double>(steps));
    if (w.extension && w.orientation && w.scene->orientation->turning)
    {
      const record::PartTimer inheriting = record::time_part(w.spent, "orientation");
      // By the distance that the velocity was extended with: new solid inherits the front's angle.
      medium::extend_inherited(*w.extension, {&w.orientation->angle}, *w.mesh);
      melt::refresh(*w.orientation, *w.mesh);
    }
  }

  /// The melt's fields are carried all the way that waits.
  void carry_the_rest(World &w)
  {
    const medium::Velocity &mean = mean_velocity(*w.uncarried);
    if (w.extension && w.orientation) // whose spin at the front is that of the velocity there
      medium::fit_at_pieces(*w.extension, {&w.uncarried->way.x, &w.uncarried->way.y},
                            w.uncarried->material, *w.mesh);
    carry(w, mean, w.uncarried->time);
    restart(*w.uncarried);
  }
} // namespace

double steps_between_advections(const World &w, const double shift)
{
  return w.uncarried ? steps_between_advections(w.uncarried->interval, shift, allowed_shift(w))
                     : 1.;
}

void advect_melt(World &w, const double dt)
{
  if (!w.uncarried)
    carry(w, *w.velocity, dt);
  else
  {
    {
      const record::PartTimer timer = record::time_part(w.spent, "mean velocity");
      add_step(*w.uncarried, *w.velocity, dt, *w.mesh);
    }
    if (is_due(*w.uncarried, allowed_shift(w)))
      carry_the_rest(w);
  }
  if (w.walls && !w.growth)
    update_cuts(w);
}

void catch_up(World &w)
{
  if (!w.uncarried || w.uncarried->steps == 0)
    return;
  carry_the_rest(w);
  if (w.walls)
    update_cuts(w);
}
