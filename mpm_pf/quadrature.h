// What the points' quadrature makes of a strained elastic body that has moved through the grid.
//
// Points that cross cells sum stresses a little wrongly, in every place in another way, and what
// they strain back and forth does not close: the body creeps. Measured on a bar whose foot is
// strained by 6 %, 2 % in the mean (benchmarks/travelling_cantilever): over 18 cells 0.5 % of its
// deflection with 2 x 2 points a cell, 0.25 % with 3 x 3, 0.2 % with 4 x 4, with the square of the
// strain; a slender beam bent to 4 % is 1.8 % too far with 2 x 2 points, 0.2 % with 4 x 4.
#pragma once

#include <string>

#include "world.h"

/// A sentence if the solid is elastically strained by more than a percent, has moved over more
/// than three cells and has fewer than 3 x 3 points a cell. Empty else.
std::string warning_on_quadrature(const World &);

/// A sentence if a body at the start is thinner than two cells (twice its area over its perimeter):
/// bending and edges are then beyond the mesh. Crystals that grow are excepted. Empty else.
std::string warning_on_thin_bodies(const World &);
