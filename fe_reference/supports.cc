#include "supports.h"

#include <algorithm>

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

    scene::Box box_of(const std::vector<Point> &positions)
    {
      scene::Box box{positions.front(), positions.front()};
      for (const Point &p : positions)
      {
        box.lower = box.lower.cwiseMin(p);
        box.upper = box.upper.cwiseMax(p);
      }
      return box;
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

    // Pins the node nearest to the middle in every direction that no support holds.
    void pin_floating_directions(const Discretisation &d, const scene::Box &box, Supports &supports)
    {
      const Point middle = 0.5 * (box.lower + box.upper);
      const auto nearest =
          std::min_element(d.position.begin(), d.position.end(),
                           [&](const Point &a, const Point &b)
                           { return (a - middle).squaredNorm() < (b - middle).squaredNorm(); });
      const auto node = static_cast<int>(nearest - d.position.begin());
      for (int c = 0; c < 2; ++c)
      {
        const bool floats =
            std::all_of(supports.held.begin(), supports.held.end(),
                        [c](const Supports::Held &held) { return held.nodes[c].empty(); });
        if (!floats)
          continue;
        Supports::Held pin;
        pin.nodes[c] = pin.all_nodes = {node};
        pin.displacement[c].emplace(scene::Expression{});
        supports.is_held[2 * node + c] = 1;
        supports.pinned += supports.pinned.empty() ? "" : " and ";
        supports.pinned += c == 0 ? "x" : "y";
        supports.held.push_back(std::move(pin));
      }
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
    const scene::Box box = box_of(d.position);
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
    pin_floating_directions(d, box, supports);
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
