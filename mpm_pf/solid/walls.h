// Moving walls before the material points: rigid, and one-sided.
//
// A wall is a held line (supports.h) that reaches across the domain and moves through the cells:
// shape functions are folded at its true place, so the nodes of the row that stands for the line
// have exactly the wall's velocity, a linear field up to the wall is exact, and the force is that
// on the line, not on some row of nodes nearby. (A half-space of nodal mass would be simpler, but
// it drags at nodes up to one and a half cells before the wall, by an amount that depends on the
// time step.)
//
// What a held line lacks is the opening and closing of a gap. A node of the line touches material
// if its mass, compared with that of the next row inside, is nearly what material that reaches
// to the wall would give:
//   m_c/m_M >= 0.9 (M_c/M_M),   M = integral of the folded function over the inner side;
// half of it would be met over a gap of a third of a cell. Sideways, at the rim of a contact, both
// masses fall alike. Only such nodes are held: with grip in both directions ("a dendrite grows onto
// the wall"), with slip across the wall only, and only against moving into it. What a wall grips
// it holds until half of that mass is left, so that it may be pulled. A point that gets
// past a wall nevertheless is put back onto it, and takes its velocity; that momentum counts in the
// reaction.
#pragma once

#include "solid/body.h"
#include "solid/moving_walls.h"

namespace solid
{
  /// Lines and supports for the walls of the scene, at rest on the sides of the domain.
  void add_walls(Supports &, const scene::Scene &);

  /// A node on the carrier row of a wall's line.
  struct WallNode
  {
    int i, j;
    std::ptrdiff_t n;
    Point wall_velocity;
    bool sticks; // it was held in the last step
  };
  /// Does the node touch material, and with slip, would it move into the wall?
  bool touches(const HeldLine &, const Fold &, const Grid &, const WallNode &);

  /// Bounds for the points over the step that ends at t: the domain up to the walls.
  void bound_by_walls(const Supports &, double t, Point &lower, Point &upper);

  /// Put points that are past a wall at time t back before it.
  void stop_at_walls(Solid &, double t);

  bool has_walls(const Supports &);

  /// Adds a call of advance, which began with that momentum, to the balance of the walls' impulses.
  void add_wall_balance(Solid &, const Point &momentum_before);

  /// The mean velocity of a line's row, which is that on the line, to the places of its nodes.
  void unfold(const Supports &, const scene::Domain &, const Grid &, NodalVelocity &);
} // namespace solid
