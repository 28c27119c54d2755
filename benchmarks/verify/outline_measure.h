// Measures of outlines (closed polylines): area, side position, and distances between two of them
// (Boost.Geometry).
#pragma once

#include <string>

#include "quantity.h"

namespace verify
{
  /// Area by the even-odd rule: outer boundaries count, holes are taken off.
  double area(const Outline &);
  double perimeter(const Outline &);

  /// Outermost position of the outline on a horizontal (`along_x`: y = `level`, the answer is an x)
  /// or vertical line; `side`: left, right, bottom or top. Throws MissingData if the line does not
  /// meet the outline.
  double side_position(const Outline &, const std::string &side, double level);

  /// The mirror image of the outline; `along`: "x" (x -> -x) or "y" (y -> -y).
  Outline mirrored(const Outline &, const std::string &along);

  /// The outline turned by `degrees` (counter-clockwise) about the origin.
  Outline rotated(const Outline &, double degrees);

  /// The outline moved by `by`.
  Outline shifted(const Outline &, const scene::Point &by);

  /// Largest distance of a vertex from the origin.
  double reach(const Outline &);

  /// The outermost vertex towards `side`: left, right, bottom or top.
  scene::Point extreme(const Outline &, const std::string &side);

  /// Area that lies in one but not in both.
  double symmetric_difference(const Outline &, const Outline &);

  /// Largest distance of a vertex of either to the other's edges.
  double hausdorff(const Outline &, const Outline &);

  /// Root mean square of these distances, over the vertices of both.
  double rms_distance(const Outline &, const Outline &);
} // namespace verify
