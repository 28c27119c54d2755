// The phi = 0 contour as unordered pieces with place, normal and curvature: one wherever it crosses
// a mesh line. Used by the distance; for closed polylines see contour.h.
//
// Along the line the straightened profile is a cubic through four nodes; across it, first and
// second derivatives come from five nodes each (fourth order) and are carried to the crossing by
// cubics too.
#pragma once

#include <vector>

#include "medium/distance.h"
#include "medium/field.h"

namespace medium
{
  /// All crossings of zero that start in an active tile of `where`, in the order of rows, then
  /// columns. Ghosts of `phi` must be filled. Curvatures are kept below one over the spacing,
  /// beyond which the mesh shows no circle.
  template <class T>
  std::vector<ContourPiece> contour_pieces(const Field<T> &phi, const Mesh &, const Tiles &where);
} // namespace medium
