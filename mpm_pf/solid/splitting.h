// Points split before their rows open gaps.
//
// At 100 % plastic strain and more, points line up in strings along the stretch with empty cells
// between; quadratic B-splines bridge about two cells, then the material tears for no physical
// reason. So, where a scene asks for it, each point knows the parallelogram of material it stands
// for (its two edges, 16 bytes), which follows the flow, dr/dt = L r. When its longest extent
// exceeds 0.8 cells the point becomes two, a quarter of the extent to each side along that
// direction: masses halved, stress, plastic strain and volume ratio copied, velocities those of the
// point's own linear field, so that mass and momentum are kept. The edges are followed every eighth
// step only; the strain of eight explicit steps is far below their need.
#pragma once

#include "solid/body.h"

namespace solid
{
  inline constexpr long stretch_interval = 8;

  /// Points from `begin` on stand for squares of their mass over `density`.
  void square_edges(Points &, double density, std::size_t begin);

  /// Edges of some points over dt with the velocity gradients they have.
  void stretch(Points &, double dt, PointRange);

  /// Split the points that are too long. The grid must be sorted afterwards.
  void split_points(Solid &);
} // namespace solid
