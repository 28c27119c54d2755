// Fewer vertices for an outline, before it is meshed.
//
// The outline of a recorded dendrite has a vertex wherever the contour crosses a grid line, often
// two of them almost on top of each other; a mesh that kept them all would have cells as small as
// the smallest gap. Douglas and Peucker's rule keeps the fewest vertices from which no dropped one
// is farther than `tolerance`; then vertices closer together than `gap` are merged. Some vertices
// must stay whatever the rule says, or an edge would leave its line, and what is held or loaded on
// it with it: the ends of straight parts, such as where a fillet begins, and those of supports and
// loads.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace fe
{
  /// Marks the vertices where a straight part longer than `longest_short` ends, and those where one
  /// of `parts` (matched within `tolerance`) does.
  std::vector<char> ends_of_parts(const scene::Polyline &, double longest_short,
                                  const std::vector<scene::Where> &parts,
                                  const scene::Box &bodies_box, double tolerance);

  struct Simplification
  {
    double tolerance, gap; // lengths in the scene's unit, see above
  };
  /// Marked vertices stay. A curve that would lose its area comes
  /// back unchanged.
  scene::Polyline simplify_outline(const scene::Polyline &, const std::vector<char> &marked,
                                   const Simplification &);
} // namespace fe
