// What a run has to say at its end about its front: places and areas where melt and solid disagree.
#pragma once

#include <string>

#include "world.h"

/// A sentence if a crystal that grew stands at a side of the domain that is no symmetry side and
/// has no wall: phi goes on beyond it (mirrored or periodic), material points end there. Empty
/// else.
std::string warning_on_sides(const World &);

/// A sentence if a crystal has melted away: no phi > 0 is left where there was some. Empty else.
std::string warning_on_melted_crystals(const World &);

/// A sentence if the areas of phi > 0 and of the material points differ by more than a twentieth.
/// Empty else.
std::string warning_on_areas(const World &);
