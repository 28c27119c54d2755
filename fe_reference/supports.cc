#include "supports.h"

#include <algorithm>

#include "outline_lengths.h"
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

    // Boxes hold what lies in them, whatever the outline does.
    void check_lengths(const scene::Scene &scene, const Discretisation &d, const scene::Box &box,
                       const double tolerance)
    {
      const OutlineLengths lengths(scene, d);
      const auto check =
          [&](const OutlineLengths::Lies &lies, const scene::Place &place, const std::string &who)
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
