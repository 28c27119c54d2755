// Fewer vertices for an outline, before it is meshed.
//
// The outline of a recorded dendrite has a vertex wherever the contour crosses a grid line, often
// two of them almost on top of each other; a mesh that kept them all would have cells as small as
// the smallest gap. Douglas and Peucker's rule keeps the fewest vertices from which no dropped one
// is farther than `tolerance`; then vertices closer together than `gap` are merged.
#pragma once

#include "scene/scene.h"

namespace fe
{
  /// Both lengths in the scene's unit. A curve that would lose its area comes back unchanged.
  scene::Polyline simplify_outline(const scene::Polyline &, double tolerance, double gap);
} // namespace fe
