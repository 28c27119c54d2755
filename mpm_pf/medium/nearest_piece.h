// Which contour piece is nearest, at every node of the mesh: the distance's own answer in its band,
// beyond it what four sweeps carry outward (a node asks the pieces of its neighbours; Danielsson,
// Comput. Graphics Image Process. 14, 227, 1980). Now and then a node takes the second nearest,
// which is nearer than the nearest by a fraction of a cell less: enough for a map of the far melt.
#pragma once

#include "medium/distance.h"

namespace medium
{
  /// Writes the index of the piece for every node into `map`; all 0 if the contour is empty.
  void find_nearest_piece(Field<int> &map, const Distance &, const Mesh &);
} // namespace medium
