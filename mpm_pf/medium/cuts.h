// Cut cells: how far the moving walls reach into the mesh, and how nodal fields end there (Sec. 3,
// Refs. [28,29] of the paper). Plain geometry: who moves the walls is in walls.h.
//
// The mesh is fixed and a wall cuts through its cells. The last active line of nodes L stands
// between 0.5 and 1.5 spacings from the wall (`gap` g); lines behind it are deactivated. The cell
// of L reaches from the face at L - 1/2 to the wall: its size is m = 1/2 + g spacings, between 1
// and 2, so a cut cell smaller than half a cell is merged with its neighbour and no step limit
// shrinks. The wall lets no heat and no phase through:
//   m d theta_L/dt = D/h^2 (theta_{L-1} - theta_L) + m D theta_xx.
// The same comes out of the regular stencil if the node behind L holds
//   f_{L+1} = f_L + (1/m - 1) (f_{L-1} - f_L),
// and that is also the even continuation of f through the wall's true place: the parabola through
// f_L and f_{L-1} whose slope vanishes at the wall. So sweeps run unchanged, and sums weighted with
// m are conserved to rounding. At a wall at rest on the border node (m = 1/2) it is the mirror
// f_{L-1}.
#pragma once

#include <array>
#include <optional>

#include "medium/field.h"

namespace medium
{
  using scene::Box;

  /// End of the active lines before one wall.
  struct Cut
  {
    int last;   // last active line of nodes
    double gap; // from there to the wall, in spacings
    double size() const { return 0.5 + gap; }
    /// f behind = f_last + share (f before last - f_last).
    double share() const { return (0.5 - gap) / (0.5 + gap); }
  };

  /// By Edge; empty where the domain ends at its border node.
  struct Cuts
  {
    std::array<std::optional<Cut>, 4> side;

    const std::optional<Cut> &at(Edge edge) const { return side[static_cast<std::size_t>(edge)]; }
    std::optional<Cut> &at(Edge edge) { return side[static_cast<std::size_t>(edge)]; }
    bool any() const { return side[0] || side[1] || side[2] || side[3]; }
    /// Active lines [first, end) along an axis that has `count` of them.
    int first(int axis) const;
    int end(int axis, int count) const;
    /// Size of the cells of one line: 1 inside, 1/2 on a border, `size` at a cut, 0 behind it.
    double size(int axis, int line, int count) const;
    /// Cell area of a node in units of a whole cell.
    double weight(int i, int j, const Mesh &mesh) const
    {
      return size(0, i, mesh.nodes[0]) * size(1, j, mesh.nodes[1]);
    }
  };

  /// The rectangle between the walls, length.
  Box active_box(const Cuts &, const Mesh &);

  /// Fills the three lines behind every cut with the continuation through the wall's true place,
  /// those further back with a constant one, and then the ghost layers. `parity` and `image` as for
  /// fill_ghosts: even for scalars; odd for the derivative along that axis, which vanishes at the
  /// wall.
  template <class T>
  void fill_behind(Field<T> &, const Cuts &, const Mesh &, Parity parity = Parity::even,
                   Image image = Image::scalar);

  /// Only the next row behind the cut at the bottom or top, ghost columns -1 and nx included: what
  /// a sweep of 3 x 3 stencils reads.
  template <class T>
  void fill_next_row(Field<T> &, const Cut &, Edge, int nx);
  /// Only the next node behind the cut columns (left, right) of one row.
  template <class T>
  void fill_next_columns(T *row, const Cuts &cuts)
  {
    if (const auto &cut = cuts.at(Edge::left))
      row[cut->last - 1] =
          row[cut->last] + static_cast<T>(cut->share()) * (row[cut->last + 1] - row[cut->last]);
    if (const auto &cut = cuts.at(Edge::right))
      row[cut->last + 1] =
          row[cut->last] + static_cast<T>(cut->share()) * (row[cut->last - 1] - row[cut->last]);
  }
} // namespace medium
