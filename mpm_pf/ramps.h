// Is what drives a solid brought to its speed slowly enough? Over fewer than ten transits of an
// elastic wave the load arrives as a wave, whose stress is up to rho c V, and rings.
#pragma once

#include <string>

#include "world.h"

/// Gives walls that wait for a front ten transits through the arm before it, and as many from the
/// contact on, where the scene does not say how they come up to speed. World: with solid and walls.
void choose_wall_ramps(World &);

/// A sentence for each wall that has touched the solid and was brought to its speed, from its
/// contact on, in fewer than ten transits through the arm before it. Empty if there is none, and
/// where an impact at that speed, rho c V, is below a hundredth of what the material bears.
std::string warning_on_wall_ramps(const World &);

/// The same for supports that are driven from rest, of bodies whose density is scaled: who scales
/// it means to load slowly, while at its true density a step may be the problem itself.
std::string warning_on_support_ramps(const World &);
