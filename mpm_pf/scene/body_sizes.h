// How thick and how long are the bodies whose deformation a mesh must resolve, and where would its
// lines better be? From this a preset chooses cells and elements.
//
// A body that a support holds whole, such as a grip, moves as it is told to: its size asks for
// nothing, however thin it is.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace scene
{
  struct BodySizes
  {
    double thinnest = 0., longest = 0.; // 0: no size is known
  };

  /// Is the support a region with all of the bodies' box in it, but for rounding? Nothing is then
  /// left free in the components that it holds.
  bool covers(const Support &, const Box &bodies);

  /// Thickness and length: the sides of the bodies' bounding boxes; of a ring its wall, and of a
  /// free outline twice its area over its perimeter, which is the width of a long strip. Bodies
  /// that supports hold whole are left out, unless all are held.
  BodySizes sizes_to_resolve(const Scene &);

  /// Where supports of a segment end, if it runs along an axis: distances from the domain's lower
  /// corner, by axis. Whole nodes are held, so a support that ends between two of them is up to
  /// half a cell too wide.
  std::array<std::vector<double>, 2> ends_of_held_segments(const Scene &);
} // namespace scene
