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

  /// How a quantity runs up to the contour from inside. linear: as the fitted line says; for what
  /// is known anew at every step, the velocity. level: without slope along the normal; for what
  /// the solid remembers, the crystal angle: new solid inherits the value at the front, and a line
  /// carried on from step to step would let a slope grow outward for ever.
  enum class Approach
  {
    linear,
    level
  };

  /// Which nodes count as solid, and how to come from them to the contour.
  struct PieceFit
  {
    const Field<unsigned char> &material; // 1 where a node has material; empty: everywhere
    double depth;                         // least psi, length
    Approach approach;
  };

  /// For each field the values at all pieces: result[field][piece]. Solid nodes within sqrt(12)
  /// cells count, with weight (1 - r^2/12h^2)^2. Where they determine no gradient (fewer than
  /// three, or in a line) it is 0 and the value their mean; a piece without solid nodes takes
  /// value, without slope, of the nearest piece that has some; 0 if none has.
  std::vector<std::vector<PieceValue>> piece_values(const Distance &,
                                                    const std::vector<Field<double> *> &fields,
                                                    const PieceFit &, const Mesh &);
} // namespace medium
