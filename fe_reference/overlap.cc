#include "overlap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace fe
{
  namespace
  {
    constexpr double depth = 0.05; // of the cell's size

    struct Quad
    {
      std::array<Point, 4> corner; // counter-clockwise
      Point lower, upper;

      bool holds(const Point &p) const
      {
        if ((p.array() < lower.array()).any() || (p.array() > upper.array()).any())
          return false;
        const double margin = depth * (upper - lower).minCoeff();
        for (int k = 0; k < 4; ++k)
        {
          const Point along = corner[(k + 1) % 4] - corner[k], to = p - corner[k];
          if (along[0] * to[1] - along[1] * to[0] < margin * along.norm())
            return false;
        }
        return true;
      }
    };

    Point current(const Discretisation &d, const std::vector<double> &u, const int node)
    {
      return d.position[node] + Point(u[2 * node], u[2 * node + 1]);
    }

    Quad quad_of(const Discretisation &d, const std::vector<double> &u, const int cell)
    {
      const std::array<int, 4> corners{0, 1, 3, 2}; // lexicographic -> counter-clockwise
      Quad quad;
      for (int k = 0; k < 4; ++k)
        quad.corner[k] = current(d, u, d.nodes_of(cell)[corners[k]]);
      quad.lower = quad.upper = quad.corner[0];
      for (const Point &p : quad.corner)
        quad.lower = quad.lower.cwiseMin(p), quad.upper = quad.upper.cwiseMax(p);
      return quad;
    }

    using Apart = std::function<bool(int node, int cell)>;

    // The cells sorted by their left ends: those that hold x start within the widest cell of it.
    std::optional<Point> overlap(const Discretisation &d, const std::vector<double> &u,
                                 const Apart &apart)
    {
      std::vector<std::pair<double, int>> by_left;
      std::vector<Quad> quads;
      double widest = 0.;
      for (int cell = 0; cell < d.cells; ++cell)
      {
        quads.push_back(quad_of(d, u, cell));
        by_left.emplace_back(quads.back().lower[0], cell);
        widest = std::max(widest, quads.back().upper[0] - quads.back().lower[0]);
      }
      std::sort(by_left.begin(), by_left.end());
      // Between the nodes too, off the middle: meshes may have their lines in common.
      for (const BoundarySide &side : d.boundary)
        for (int k = 0; k < d.degree; ++k)
          for (const double s : {0., 0.3, 0.7})
          {
            const Point x =
                (1. - s) * current(d, u, side.node[k]) + s * current(d, u, side.node[k + 1]);
            for (auto near = std::lower_bound(by_left.begin(), by_left.end(),
                                              std::make_pair(x[0] - widest, -1));
                 near != by_left.end() && near->first <= x[0]; ++near)
              if (quads[near->second].holds(x) && apart(side.node[k], near->second))
                return x;
          }
      return std::nullopt;
    }
  } // namespace

  std::optional<Point> overlap_of_pieces(const Discretisation &d, const std::vector<int> &piece,
                                         const std::vector<double> &u)
  {
    return overlap(d, u,
                   [&](const int node, const int cell)
                   { return piece[node] != piece[d.nodes_of(cell)[0]]; });
  }

  std::optional<Point> overlap_with_itself(const Discretisation &d, const std::vector<int> &piece,
                                           const std::vector<double> &u,
                                           const std::vector<char> &folded)
  {
    std::vector<std::vector<int>> cells_of(d.nodes);
    for (int cell = 0; cell < d.cells; ++cell)
      for (int a = 0; a < d.nodes_per_cell; ++a)
        cells_of[d.nodes_of(cell)[a]].push_back(cell);
    const auto apart = [&](const int node, const int cell)
    {
      if (folded[cell] || piece[node] != piece[d.nodes_of(cell)[0]])
        return false;
      std::set<int> own; // nodes of the cells around the node, and of their neighbours
      for (const int first : cells_of[node])
        for (int a = 0; a < d.nodes_per_cell; ++a)
          for (const int second : cells_of[d.nodes_of(first)[a]])
            own.insert(d.nodes_of(second), d.nodes_of(second) + d.nodes_per_cell);
      return std::none_of(d.nodes_of(cell), d.nodes_of(cell) + d.nodes_per_cell,
                          [&](const int other) { return own.count(other) != 0; });
    };
    return overlap(d, u, apart);
  }
} // namespace fe
