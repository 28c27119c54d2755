// The shared Eulerian mesh: a regular grid of nodes, the same for the melt's fields and for the
// momentum of the material points.
//
// Nodes sit on the domain's border (nodes = cells + 1 each way), so a no-flux or symmetry wall is a
// mirror through the border node: f(-1) = f(1). A border node therefore owns half a cell (a corner
// a quarter), and sums weighted this way are what a conservative scheme conserves. On a periodic
// pair of sides the first and the last node are one and the same place, stored twice.
#pragma once

#include <array>

#include "scene/scene.h"

namespace medium
{
  using scene::Boundary;
  using scene::Edge;
  using scene::Point;

  /// Ghost layers round every nodal field: as many as the widest stencil (WENO5) reads.
  inline constexpr int ghost_layers = 3;

  struct Mesh
  {
    std::array<int, 2> nodes{0, 0};     // cells + 1
    Point lower = Point::Zero();        // position of node (0, 0), length
    Point spacing = Point::Ones();      // length
    std::array<Boundary, 4> boundary{}; // indexed by Edge

    Point position(int i, int j) const
    {
      return {lower[0] + i * spacing[0], lower[1] + j * spacing[1]};
    }
    Boundary side(Edge edge) const { return boundary[static_cast<std::size_t>(edge)]; }
    long node_count() const { return static_cast<long>(nodes[0]) * nodes[1]; }

    /// Share of a whole cell that node (i, j) owns: 1 inside, 1/2 on a side, 1/4 in a corner.
    double weight(int i, int j) const
    {
      return (i == 0 || i == nodes[0] - 1 ? 0.5 : 1.) * (j == 0 || j == nodes[1] - 1 ? 0.5 : 1.);
    }
  };

  /// The mesh of a scene's domain. Throws std::invalid_argument if a direction has fewer than 3
  /// cells (stencils and mirrors need them) or if only one of two opposite sides is periodic.
  Mesh make_mesh(const scene::Domain &);

  /// Node whose value a ghost (or any) index takes along one axis of `count` nodes: itself inside;
  /// beyond a mirror the reflected node; beyond a periodic side the node one period away.
  int source_index(int index, int count, Boundary low, Boundary high);
} // namespace medium
