// The phi = 0 contour as closed polylines: marching squares with subcell-accurate vertices.
//
// A vertex lies where the field crosses zero on a mesh line, found on the cubic through four nodes
// (crossing.h), so it is fourth-order accurate; the polygon between the vertices is second-order in
// area and length. The solid lies to the left of the walk: outlines run counter-clockwise (positive
// area), holes clockwise. Where solid meets the border of the domain (or a moving wall) the
// polyline is closed along it. A cell with two solid corners across its diagonal is joined or split
// by the sign of the mean of its corners.
#pragma once

#include <optional>
#include <vector>

#include "medium/crossing.h"
#include "medium/field.h"

namespace medium
{
  using scene::Box;
  using scene::Polyline;

  /// The zero contour of `field`, positions in length; ghosts are not read. `active`: the rectangle
  /// between moving walls, when it is smaller than the domain: nodes outside it are ignored, the
  /// field is continued evenly (no flux) to its sides, and polylines close along them.
  template <class T>
  std::vector<Polyline> contour(const Field<T> &field, const Mesh &,
                                Profile profile = Profile::tanh_of_distance,
                                const std::optional<Box> &active = std::nullopt);

  /// Enclosed area, holes subtracted; length^2.
  double enclosed_area(const std::vector<Polyline> &);

  /// Length of the contour inside `inner` (the domain, or the rectangle between the walls): parts
  /// that run along its sides, where solid meets the border, do not count.
  double interface_length(const std::vector<Polyline> &, const Box &inner);

  /// The rectangle of all nodes.
  Box extent(const Mesh &);
} // namespace medium
