// Symmetry sides of the domain: beyond one lies the mirror image of what is inside.
//
// Points near such a side bring mass, momentum and force to nodes beyond it as they do to any. All
// of that belongs to the images of these nodes, with the component across the side turned round: so
// much the points beyond, which nobody keeps, would have brought there. Before points are moved the
// nodes beyond get the velocities of their images. So a half, or a quarter, of a symmetric body
// does to rounding what it does as a part of the whole. (Nodes on the side get half of what they
// would have in the whole: mass, momentum and force alike.) To fold the shape functions, as at
// supports, would leave a velocity along the side a slope across it.
#pragma once

#include <cstdlib>

#include "solid/grid.h"

namespace solid
{
  /// A node, or the one inside of which it is the image.
  struct Image
  {
    std::ptrdiff_t node;        // -1: without memory
    std::array<double, 2> sign; // of components: -1 beyond a side across it, 0 on one, else 1
    double whole;               // the whole's mass over its own: 2 on a side, 4 where two meet
    std::array<int, 2> at{};    // its column and row

    Point apply(const Point &v) const { return {sign[0] * v[0], sign[1] * v[1]}; }
  };
  Image image_of(const Grid &, int i, int j);

  /// A node that no side turns, used as an Image where that is known: most are.
  struct Straight
  {
    static constexpr std::array<double, 2> sign{1., 1.};
    static constexpr double whole = 1.;
    const Point &apply(const Point &v) const { return v; }
  };
  /// May a node at most `reach` from (i, j) be on a side or beyond?
  inline bool near_mirror(const Grid &grid, const int i, const int j, const int reach)
  {
    for (const Mirror &mirror : grid.mirrors)
      if (std::abs((mirror.axis == 0 ? i : j) - mirror.row) <= reach)
        return true;
    return false;
  }

  /// Does node (i, j) lie on a symmetry side across `axis`?
  bool on_mirror(const Grid &, int axis, int i, int j);

  /// What nodes beyond symmetry sides have been brought goes to their images.
  void fold_images(Grid &);
  /// Velocities, and their change, of nodes beyond symmetry sides from their images.
  void reflect_velocities(Grid &);
} // namespace solid
