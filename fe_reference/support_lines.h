// Where supports begin and end, for a mesh that follows outlines.
//
// A support holds the nodes that lie in it, so that its end must be a vertex and the side of a held
// box a line of the mesh: else up to a cell less is held than was asked for.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace fe
{
  struct EndTolerances
  {
    double gap, matching; // lengths
  };
  /// The outline with vertices where a part (within `matching`) begins or ends on it; none
  /// closer than `gap` to another.
  scene::Polyline with_ends(const scene::Polyline &, const std::vector<scene::Where> &parts,
                            const EndTolerances &);

  /// Sides of held boxes in the material, cut at the outlines and shorter pieces than `gap` left
  /// out; empty if boxes meet, whose sides might cross.
  std::vector<std::array<scene::Point, 2>>
  held_lines_inside(const std::vector<scene::Body> &, const scene::Domain &,
                    const std::vector<scene::Polyline> &outlines,
                    const std::vector<scene::Support> &, double gap);
} // namespace fe
