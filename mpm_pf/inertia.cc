#include "inertia.h"

#include <cmath>
#include <iomanip>
#include <sstream>

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
} // namespace

Inertia inertia(const World &world)
{
  const auto &wall = world.walls->walls.front();
  const bool mirrored =
      world.walls->walls.size() == 1 &&
      world.mesh->side(wall.axis() == 0 ? scene::Edge::left : scene::Edge::bottom) ==
          scene::Boundary::symmetry;
  const double span = wall.touched ? wall.span_at_touch : world.scene->domain.size[wall.axis()];
  Inertia found;
  found.arm = mirrored ? span : span / 2.;
  found.numbers = solid::quasi_static(*world.solid, found.arm, wall.asked.speed);
  return found;
}

std::string verdict_on_inertia(const World &world)
{
  if (!world.solid || !world.walls || medium::compression(*world.walls) == 0.)
    return {};
  const Inertia now = inertia(world);
  const double alone = now.compression(), reached = medium::compression(*world.walls);
  const bool opposed = world.walls->walls.size() > 1;
  std::string text = "inertia alone takes " + percent(alone) +
                     " of compression to stop an arm; kinetic energy is " +
                     percent(now.numbers.kinetic_to_internal) + " of the internal";
  if (opposed)
    text += "; opposite wall forces differ by " + percent(now.numbers.force_imbalance);
  // Twice the travel of one yield stress: beyond it the arm has been brought to speed.
  const bool still =
      now.numbers.kinetic_to_internal < 0.05 && (!opposed || now.numbers.force_imbalance < 0.1);
  if (still && 2. * alone < reached)
    text += ": quasi-static beyond " + percent(2. * alone);
  else
    text += ": not quasi-static";
  return text;
}
