// Vertices of joined outlines, exact again.
//
// Boost.Geometry 1.74 joins areas on a grid of integers: what it returns is off by some 1e-7 of the
// size. What lies on a straight edge must lie on it to rounding, since supports and loads ask for
// it: every vertex is a vertex of what was joined, or where two of its sides cross.
#pragma once

#include <vector>

#include "scene/domain.h"

namespace scene
{
  /// `joined` with its vertices moved, by no more than some 1e-6 of the size, to vertices and
  /// crossings of the closed polylines `given` that were joined; vertices that then coincide become
  /// one.
  std::vector<Polyline> exact_vertices(std::vector<Polyline> joined,
                                       const std::vector<Polyline> &given);
} // namespace scene
