// Nodes that hardly any material reaches follow the nodes behind them.
//
// The mass of a node goes to zero with w, its force only with grad w. So at the rim of a body the
// few points in reach, never quite in balance, move a light node without limit: dv = dt f/m, and
// the stresses lose 1/2 m dv^2 that the points do not get (see transfer.h). An elastic cantilever
// bent far gives away a fifth of its work like that and creeps under its load.
//
// Here a light node I resists being accelerated otherwise than the nodes behind it say,
//   a_w = sum of omega_d (2 a_(I+d) - a_(I+2d)) over the directions d into the material,
// by an inertia alpha: q = alpha (a_I - a_w) goes from the force on I to these nodes. That is an
// energy alpha/2 |v_I - v_w|^2 of the relative motion and nothing else: momentum and angular
// momentum stay, and what is linear in x (rigid motions, gravity) feels nothing. m_I + alpha is a
// fixed fraction of a full cell's mass. To tie the functions that a rim cuts to those inside is
// what extended B-splines do (Hoellig, Reif, Wipper 2001); here only accelerations are tied, and
// the lighter a node, the more. All this is that of the whole body where a symmetry side cuts it.
#pragma once

#include "solid/mirrors.h"
#include "solid/supports.h"

namespace solid
{
  struct LightNode
  {
    std::ptrdiff_t node = 0;
    std::array<int, 2> at{0, 0};           // its column and row
    std::uint8_t components = 0;           // bit c: component c is not held
    bool straight = true;                  // no symmetry side is near
    std::array<std::ptrdiff_t, 16> behind; // I + d, I + 2d of each direction, or their images
    std::array<double, 16> weight;         // sum 1; unused: 0
    Point impulse = Point::Zero();         // that it loses
  };

  /// Lists kept from step to step for their memory only.
  struct LightNodes
  {
    /// Are those in the row before a support's line tied as well? Linear functions are not stable
    /// there else; of smooth ones, which are, a tie to rows where they are folded costs accuracy:
    /// the loop of tension_compression is 0.95 % off then instead of 0.25 %.
    bool before_supports = false;
    std::vector<std::vector<LightNode>> found; // by rows of nodes
    std::vector<std::uint8_t> leaning;         // how many lean on a node
  };

  /// Correct the velocities v = (p + dt f)/m of free nodes lighter than `least` and of those behind
  /// them, before supports hold any. The same bits for any number of threads.
  void tie_light_nodes(LightNodes &, const Supports &, Grid &, double least, double dt,
                       int threads);
} // namespace solid
