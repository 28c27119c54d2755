// What crosses a mirror side (no flux, symmetry) of the mesh.
//
// A motion that crosses a mirror is not its own mirror image, and what the ghosts beyond would send
// in is the field inside, carried backwards. A scalar's side then moves by the square of the shift
// s only and stands still in short steps. The angle beyond a symmetry side, 2 f(0) - f(1), is
// worse: the side's value grows by 1 + s a step, in short steps as exp(u t/h), from round-off
// alone.
//
// So nothing comes from beyond: material that enters has the side's own value and no slope along
// the normal, df/dt + v df/dy = 0 on a side x = const, and what leaves is told by the inside alone.
// Where nothing crosses, a field stays its own mirror image.
#pragma once

#include <cmath>

#include "medium/departure.h"

namespace medium
{
  /// Of which mirror sides a node is part.
  struct MirrorSides
  {
    bool left, right, bottom, top;
    bool any() const { return left || right || bottom || top; }
  };

  inline bool is_mirror(Boundary boundary)
  {
    return boundary == Boundary::no_flux || boundary == Boundary::symmetry;
  }

  inline MirrorSides mirror_sides(const Mesh &mesh, int i, int j)
  {
    const auto on = [&](bool here, Edge edge) { return here && is_mirror(mesh.side(edge)); };
    return {on(i == 0, Edge::left), on(i == mesh.nodes[0] - 1, Edge::right),
            on(j == 0, Edge::bottom), on(j == mesh.nodes[1] - 1, Edge::top)};
  }

  /// Calls `visit(i, sides)` for the nodes of row j that are part of a mirror side.
  template <class Visit>
  void for_mirror_nodes(const Mesh &mesh, int j, const Visit &visit)
  {
    const int last = mesh.nodes[0] - 1;
    const bool whole_row = mirror_sides(mesh, 1, j).any();
    for (int i = 0; i <= last; i += whole_row ? 1 : last)
      if (const MirrorSides sides = mirror_sides(mesh, i, j); sides.any())
        visit(i, sides);
  }

  /// Whether a shift towards the place of departure comes from beyond a side.
  inline bool enters_along_x(double shift, const MirrorSides &s)
  {
    return (s.left && shift < 0.) || (s.right && shift > 0.);
  }
  inline bool enters_along_y(double shift, const MirrorSides &s)
  {
    return (s.bottom && shift < 0.) || (s.top && shift > 0.);
  }

  /// A velocity's components (or shifts by it), as they are where material enters: none across.
  inline double along_side_x(double u, const MirrorSides &s)
  {
    return enters_along_x(-u, s) ? 0. : u;
  }
  inline double along_side_y(double v, const MirrorSides &s)
  {
    return enters_along_y(-v, s) ? 0. : v;
  }

  /// The departure as it is where material enters: on the side itself, where the field has no slope
  /// along the normal. Returns whether that changes anything.
  inline bool depart_from_side(Departure &d, const MirrorSides &sides)
  {
    const bool x = enters_along_x(d.x, sides), y = enters_along_y(d.y, sides);
    if (x)
      d.x = d.xx = 0.;
    if (y)
      d.y = d.yy = 0.;
    if (x || y)
      d.xy = d.yx = 0.;
    return x || y;
  }

  /// Calls `carry(i, departure)` for the nodes of row j where material enters, with the departure
  /// from the side.
  template <class Carry>
  void for_entering_nodes(const Mesh &mesh, int j, const VelocityRows &w, StepInCells step,
                          const Carry &carry)
  {
    for_mirror_nodes(mesh, j,
                     [&](int i, const MirrorSides &sides)
                     {
                       Departure d = departure(w, i, step);
                       if (depart_from_side(d, sides))
                         carry(i, d);
                     });
  }

  /// Does a shift, in cells, cross a side? What is smaller is round-off of a motion along it.
  inline bool crosses(double shift)
  {
    return std::fabs(shift) > 1e-9;
  }
} // namespace medium
