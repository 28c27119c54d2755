#include "follow_outline.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    using Side = std::array<Point, 2>;

    // Sides by the columns of the plane, `width` wide, that they reach into.
    struct Columns
    {
      double width;
      std::multimap<long, Side> sides = {};

      long column(const double x) const { return std::lround(std::floor(x / width)); }

      void add(const Side &side)
      {
        const auto [left, right] = std::minmax(side[0][0], side[1][0]);
        for (long k = column(left); k <= column(right); ++k)
          sides.emplace(k, side);
      }

      // `p` itself if nothing is near.
      Point nearest(const Point &p) const
      {
        Point best = p;
        double distance = width;
        const auto end = sides.upper_bound(column(p[0]) + 1);
        for (auto entry = sides.lower_bound(column(p[0]) - 1); entry != end; ++entry)
        {
          const auto &[a, b] = entry->second;
          const Point foot = a + scene::along_segment(p, a, b) * (b - a);
          if ((p - foot).norm() < distance)
            distance = (p - foot).norm(), best = foot;
        }
        return best;
      }
    };

    std::vector<char> on_boundary(const QuadMesh &mesh)
    {
      std::map<std::array<int, 2>, int> cells_at;
      for (const auto &cell : mesh.cells)
        for (int k = 0; k < 4; ++k)
          ++cells_at[{std::min(cell[k], cell[(k + 1) % 4]), std::max(cell[k], cell[(k + 1) % 4])}];
      std::vector<char> on(mesh.vertices.size(), 0);
      for (const auto &[side, cells] : cells_at)
        if (cells == 1)
          on[side[0]] = on[side[1]] = 1;
      return on;
    }

    // Twice the area of the triangle at the cell's sharpest corner.
    double smallest_corner(const QuadMesh &mesh, const std::array<int, 4> &cell)
    {
      double smallest = HUGE_VAL;
      for (int k = 0; k < 4; ++k)
      {
        const Point &at = mesh.vertices[cell[k]];
        const Point a = mesh.vertices[cell[(k + 1) % 4]] - at,
                    b = mesh.vertices[cell[(k + 3) % 4]] - at;
        smallest = std::min(smallest, a[0] * b[1] - a[1] * b[0]);
      }
      return smallest;
    }
  } // namespace

  void follow_outline(QuadMesh &mesh, const std::vector<scene::Polyline> &outlines,
                      const double farthest)
  {
    Columns columns{farthest};
    for (const scene::Polyline &outline : outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
        columns.add({outline[k], outline[(k + 1) % outline.size()]});
    std::vector<std::vector<int>> cells_of(mesh.vertices.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (const int vertex : mesh.cells[c])
        cells_of[vertex].push_back(static_cast<int>(c));
    const std::vector<char> on = on_boundary(mesh);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
      if (!on[v])
        continue;
      const Point before = mesh.vertices[v], moved = columns.nearest(before);
      const auto keeps_its_shape = [&](const int c)
      {
        const double was = smallest_corner(mesh, mesh.cells[c]);
        mesh.vertices[v] = moved;
        const double is = smallest_corner(mesh, mesh.cells[c]);
        mesh.vertices[v] = before;
        return is > 0.3 * was;
      };
      if (std::all_of(cells_of[v].begin(), cells_of[v].end(), keeps_its_shape))
        mesh.vertices[v] = moved;
    }
  }
} // namespace fe
