// What the solid knows at the contour: value and gradient of nodal fields at each contour piece,
// from a weighted least-squares line through the solid nodes around it (extension.h).
#pragma once

#include <vector>

#include "medium/distance.h"

namespace medium
{
  /// Value (the field's unit) and gradient (per length) at one piece.
  struct PieceValue
  {
    double value = 0., slope_x = 0., slope_y = 0.;
  };

  /// For each field the values at all pieces: result[field][piece]. Solid is what has `material`
  /// (empty: all) and psi >= depth. Nodes within sqrt(12) cells count, with weight (1 -
  /// r^2/12h^2)^2. Where they determine no gradient (fewer than three, or in a line) it is 0 and
  /// the value their mean; a piece without solid nodes takes value, without slope, of the nearest
  /// piece that has some; 0 if none has.
  std::vector<std::vector<PieceValue>> piece_values(const Distance &,
                                                    const std::vector<Field<double> *> &fields,
                                                    const Field<unsigned char> &material,
                                                    double depth, const Mesh &);
} // namespace medium
