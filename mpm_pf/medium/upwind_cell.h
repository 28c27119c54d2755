// The corners of the upwind cell of a node, gathered without branches.
#pragma once

#include "medium/field.h"

namespace medium
{
  /// Three rows of one field round the row in hand, and the row where its new values go.
  struct FieldRows
  {
    const double *below, *here, *above;
    double *next;
  };

  /// Values at the corners of the cell on the upwind side of a node.
  struct UpwindCorners
  {
    double near, right, up, far;
  };

  /// Corners of node i's cell towards +x if `right`, +y if `up`, times `scale`.
  [[gnu::always_inline]] inline UpwindCorners corners(const FieldRows &r, int i, bool right,
                                                      bool up, double scale)
  {
    const double e = r.here[i + 1], w = r.here[i - 1], n = r.above[i], s = r.below[i];
    const double ne = r.above[i + 1], nw = r.above[i - 1], se = r.below[i + 1], sw = r.below[i - 1];
    const double high = right ? ne : nw, low = right ? se : sw;
    return {scale * r.here[i], scale * (right ? e : w), scale * (up ? n : s),
            scale * (up ? high : low)};
  }
} // namespace medium
