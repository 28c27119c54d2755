// The first material points of the bodies.
//
// Where every body is a rectangle on the lattice of points, or there is a single rectangle, the
// points tile it exactly, each at the centre of its share. Any other shape is cut by a lattice of
// the domain: a share that the outline crosses gets its inside area (8 x 8 samples) and the
// centroid of that; slivers below a fifth of a share are dropped and their area given to the other
// cut shares, so the area of the body is kept.
#pragma once

#include "solid/material.h"
#include "solid/points.h"

namespace solid
{
  /// Points with mass, initial velocity and initial stress. Throws scene::BadScene if a body gets
  /// none, or reaches out of the domain (over a symmetry side it is cut).
  Points make_points(const scene::Scene &, const Material &, const std::array<int, 2> &per_cell);

  /// Initial velocity and stress of the points from `begin` on, those of the body that a point is
  /// deepest in; `h` is the half-width of the differences that give the velocity's gradient.
  void initialise(Points &, const Fraction &, std::size_t begin,
                  const std::vector<scene::Body> &bodies, double h);
} // namespace solid
