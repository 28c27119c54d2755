// Which displacements are held, where, and how they move.
//
// A support on an edge or a segment holds the nodes of the outline that lie on it at the start; a
// support on a region holds every node that starts inside (a grip). Each component is held or free
// by itself; where two supports claim the same one, the first in the scene holds it. Symmetry sides
// of the domain hold what no support does: there the normal displacement is zero. A direction
// that nothing holds (a strip pulled along y, free to contract) has no equilibrium position of its
// own: in each piece of the mesh one node near the middle is pinned in it. That does no work, and a
// pin carries no force: where it does, the loads are not in balance and there is no equilibrium.
#pragma once

#include <string>
#include <vector>

#include "discretisation.h"
#include "scene/expression.h"

namespace fe
{
  struct Supports
  {
    struct Held
    {
      std::string name;
      std::array<std::vector<int>, 2> nodes; // by component
      std::vector<int> all_nodes;            // all that the support names, held or not
      std::array<std::optional<scene::Function>, 2> displacement;
    };
    std::vector<Held> held;
    std::vector<char> is_held; // unknowns
    std::string pinned;        // directions pinned so, as text; empty: none
    std::vector<int> pins;     // unknowns
    std::vector<int> piece;    // of each node (pieces.h)

    bool all_held() const;
  };

  /// Throws scene::BadScene if a support holds no node.
  Supports make_supports(const scene::Scene &, const Discretisation &);

  /// Displacements `u` (unknowns) with the held ones set to their values at time `t`. One that
  /// depends on the current x or y takes them from `u`: an increment's are those of its first guess
  /// (the last velocity carried on, or rest), second order in the increment as the march is.
  std::vector<double> impose(const Supports &, const Discretisation &, std::vector<double> u,
                             double t);
} // namespace fe
