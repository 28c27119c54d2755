#include "supports.h"

#include <algorithm>
#include <map>

#include "outline_lengths.h"
#include "pieces.h"
#include "scene/geometry.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    std::vector<char> nodes_of_outline(const Discretisation &d)
    {
      std::vector<char> on(d.nodes, 0);
      for (const BoundarySide &side : d.boundary)
        for (int k = 0; k <= d.degree; ++k)
          on[side.node[k]] = 1;
      return on;
    }

    // Normal displacement zero where the body meets a symmetry side of the domain.
    void hold_symmetry_sides(const scene::Domain &domain, const Discretisation &d,
                             const double tolerance, Supports &supports)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        Supports::Held side;
        for (int n = 0; n < d.nodes; ++n)
          if (on_symmetry_side(domain, axis, d.position[n], tolerance) &&
              !supports.is_held[2 * n + axis])
          {
            supports.is_held[2 * n + axis] = 1;
            side.nodes[axis].push_back(n);
            side.all_nodes.push_back(n);
          }
        side.displacement[axis].emplace(scene::Expression{});
        if (!side.all_nodes.empty())
          supports.held.push_back(std::move(side));
      }
    }

    // The node of the piece nearest to the middle of its box.
    int middle_node(const Discretisation &d, const std::vector<int> &nodes)
    {
      scene::Box box{d.position[nodes.front()], d.position[nodes.front()]};
      for (const int n : nodes)
        box = {box.lower.cwiseMin(d.position[n]), box.upper.cwiseMax(d.position[n])};
      const Point middle = 0.5 * (box.lower + box.upper);
      return *std::min_element(nodes.begin(), nodes.end(),
                               [&](const int a, const int b) {
                                 return (d.position[a] - middle).squaredNorm() <
                                        (d.position[b] - middle).squaredNorm();
                               });
    }

    // Pins one node of every piece in every direction in which no support holds the piece.
    void pin_floating_directions(const Discretisation &d, Supports &supports)
    {
      const std::vector<int> &piece = supports.piece =
          connected_pieces(d.nodes, d.cell_node, d.nodes_per_cell);
      std::map<int, std::vector<int>> nodes_of;
      for (int n = 0; n < d.nodes; ++n)
        nodes_of[piece[n]].push_back(n);
      std::array<bool, 2> pinned{};
      for (const auto &[root, nodes] : nodes_of)
        for (int c = 0; c < 2; ++c)
        {
          if (std::any_of(nodes.begin(), nodes.end(),
                          [&, c](const int n) { return supports.is_held[2 * n + c] != 0; }))
            continue;
          const int node = middle_node(d, nodes);
          Supports::Held pin;
          pin.nodes[c] = pin.all_nodes = {node};
          pin.displacement[c].emplace(scene::Expression{});
          supports.is_held[2 * node + c] = 1;
          supports.pins.push_back(2 * node + c);
          supports.held.push_back(std::move(pin));
          pinned[c] = true;
        }
      supports.pinned = pinned[0] && pinned[1] ? "x and y" : pinned[0] ? "x" : pinned[1] ? "y" : "";
    }

    // Boxes hold what lies in them, whatever the outline does.
    void check_lengths(const scene::Scene &scene, const Discretisation &d, const scene::Box &box,
                       const double tolerance)
    {
      const OutlineLengths lengths(scene, d);
      const auto check = [&](const OutlineLengths::PointTest &lies,
                             const scene::SourceLocation &place, const std::string &who)
      { lengths.check(lies, lengths.of_mesh(lies), place, who); };
      for (const scene::Support &support : scene.supports)
        if (!std::holds_alternative<scene::Box>(support.where))
          check([&](const Point &X) { return scene::contains(support.where, box, X, tolerance); },
                support.place, "support '" + support.name + "' holds");
      for (const int axis : {0, 1})
        check([&](const Point &X) { return on_symmetry_side(scene.domain, axis, X, tolerance); },
              scene.domain.place,
              std::string("the symmetry sides across ") + (axis == 0 ? "x" : "y") + " hold");
    }
  } // namespace

  bool Supports::all_held() const
  {
    return std::all_of(is_held.begin(), is_held.end(), [](const char held) { return held != 0; });
  }

  Supports make_supports(const scene::Scene &scene, const Discretisation &d)
  {
    Supports supports;
    supports.is_held.assign(d.unknowns(), 0);
    const std::vector<char> on_outline = nodes_of_outline(d);
    const scene::Box box = scene::bounding_box(scene.bodies);
    const double tolerance = matching_tolerance(box);
    for (const scene::Support &support : scene.supports)
    {
      Supports::Held held;
      held.name = support.name;
      const bool region = std::holds_alternative<scene::Box>(support.where);
      for (int n = 0; n < d.nodes; ++n)
        if ((region || on_outline[n]) &&
            scene::contains(support.where, box, d.position[n], tolerance))
          held.all_nodes.push_back(n);
      if (held.all_nodes.empty())
        throw scene::BadScene(support.place.file + ":" + std::to_string(support.place.line) +
                              ": support '" + support.name +
                              "' holds no node of the mesh; move it onto the material or ask "
                              "for smaller cells in [fe] cells");
      for (int c = 0; c < 2; ++c)
        if (support.displacement[c])
        {
          held.displacement[c].emplace(*support.displacement[c]);
          for (const int n : held.all_nodes)
            if (!supports.is_held[2 * n + c])
            {
              supports.is_held[2 * n + c] = 1;
              held.nodes[c].push_back(n);
            }
        }
      supports.held.push_back(std::move(held));
    }
    hold_symmetry_sides(scene.domain, d, tolerance, supports);
    check_lengths(scene, d, box, tolerance);
    pin_floating_directions(d, supports);
    return supports;
  }

  std::vector<double> impose(const Supports &supports, const Discretisation &d,
                             std::vector<double> u, const double t)
  {
    for (const Supports::Held &held : supports.held)
      for (int c = 0; c < 2; ++c)
        for (const int n : held.nodes[c])
        {
          scene::Argument argument;
          argument.X = d.position[n];
          argument.x = d.position[n] + Point(u[2 * n], u[2 * n + 1]);
          argument.t = t;
          u[2 * n + c] = (*held.displacement[c])(argument);
        }
    return u;
  }
} // namespace fe
