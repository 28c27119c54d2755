#include <algorithm>
#include <cmath>

#include "mesh.h"
#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    // Sorted coordinates, those closer than `tolerance` taken as one.
    std::vector<double> distinct(std::vector<double> values, const double tolerance)
    {
      std::sort(values.begin(), values.end());
      const auto last =
          std::unique(values.begin(), values.end(),
                      [tolerance](const double a, const double b) { return b - a < tolerance; });
      values.erase(last, values.end());
      return values;
    }

    bool near_any(const std::vector<double> &values, const double x, const double tolerance)
    {
      return std::any_of(values.begin(), values.end(),
                         [&](const double value) { return std::abs(value - x) < tolerance; });
    }

    // Corners of rectangles at which a held edge or segment ends, and ends of held segments between
    // corners: x and y coordinates.
    std::array<std::vector<double>, 2> held_corners(const std::vector<scene::Body> &bodies,
                                                    const std::vector<scene::Support> &supports,
                                                    const double tolerance)
    {
      std::array<std::vector<double>, 2> coordinates;
      const scene::Box box = scene::bounding_box(bodies);
      for (const scene::Body &body : bodies)
      {
        const auto &rectangle = std::get<scene::Rectangle>(body.shape);
        for (int corner = 0; corner < 4; ++corner)
        {
          const Point p = rectangle.corner + Point(corner % 2 ? rectangle.size[0] : 0.,
                                                   corner / 2 ? rectangle.size[1] : 0.);
          for (const scene::Support &support : supports)
            if (!std::holds_alternative<scene::Box>(support.where) &&
                scene::contains(support.where, box, p, tolerance))
              for (int d = 0; d < 2; ++d)
                coordinates[d].push_back(p[d]);
        }
      }
      for (const scene::Support &support : supports)
        if (const auto *segment = std::get_if<scene::Segment>(&support.where))
          for (const Point &p : {segment->a, segment->b})
            for (int d = 0; d < 2; ++d)
              coordinates[d].push_back(p[d]);
      return coordinates;
    }

    // Where a segment or box begins and ends along one axis; of an edge the bodies say it.
    std::vector<double> extent(const scene::Where &part, const int d)
    {
      if (const auto *segment = std::get_if<scene::Segment>(&part))
        return {segment->a[d], segment->b[d]};
      if (const auto *inside = std::get_if<scene::Box>(&part))
        return {inside->lower[d], inside->upper[d]};
      return {};
    }

    // s in [0, 1] -> [0, 1], crowded towards the ends asked for.
    double graded(const double s, const bool lower, const bool upper, const double power)
    {
      if (lower && upper)
        return s < 0.5 ? 0.5 * std::pow(2. * s, power) : 1. - 0.5 * std::pow(2. * (1. - s), power);
      if (lower)
        return std::pow(s, power);
      if (upper)
        return 1. - std::pow(1. - s, power);
      return s;
    }

    std::vector<double> grid_lines(const std::vector<double> &edges, const double spacing,
                                   const std::vector<double> &corners, const double grading,
                                   const double tolerance)
    {
      const double power = 1. / (1. - std::min(grading, 0.9));
      std::vector<double> lines{edges.front()};
      for (std::size_t k = 0; k + 1 < edges.size(); ++k)
      {
        const double a = edges[k], length = edges[k + 1] - a;
        const int cells = std::max(1, static_cast<int>(std::lround(length / spacing)));
        const bool lower = near_any(corners, a, tolerance);
        const bool upper = near_any(corners, edges[k + 1], tolerance);
        for (int i = 1; i < cells; ++i)
          lines.push_back(a + length * graded(static_cast<double>(i) / cells, lower, upper, power));
        lines.push_back(edges[k + 1]);
      }
      return lines;
    }

    // Keep the cells inside the union, number the vertices that they use.
    QuadMesh keep_inside(const std::vector<scene::Body> &bodies,
                         const std::array<std::vector<double>, 2> &lines)
    {
      QuadMesh mesh;
      const std::size_t nx = lines[0].size(), ny = lines[1].size();
      std::vector<int> number(nx * ny, -1);
      const auto vertex = [&](const std::size_t i, const std::size_t j)
      {
        int &n = number[j * nx + i];
        if (n < 0)
        {
          n = static_cast<int>(mesh.vertices.size());
          mesh.vertices.emplace_back(lines[0][i], lines[1][j]);
        }
        return n;
      };
      for (std::size_t j = 0; j + 1 < ny; ++j)
        for (std::size_t i = 0; i + 1 < nx; ++i)
        {
          const Point centre(0.5 * (lines[0][i] + lines[0][i + 1]),
                             0.5 * (lines[1][j] + lines[1][j + 1]));
          if (scene::signed_distance(bodies, centre) > 0.)
            mesh.cells.push_back(
                {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
      return mesh;
    }
  } // namespace

  QuadMesh mesh_rectangles(const std::vector<scene::Body> &bodies, const std::array<int, 2> &cells,
                           const double grading, const std::vector<scene::Support> &supports,
                           const std::vector<scene::Where> &parts)
  {
    const scene::Box box = scene::bounding_box(bodies);
    const double tolerance = 1e-9 * (box.upper - box.lower).norm();
    const auto corners = held_corners(bodies, supports, tolerance);
    std::array<std::vector<double>, 2> lines;
    for (int d = 0; d < 2; ++d)
    {
      std::vector<double> edges;
      for (const scene::Body &body : bodies)
      {
        const auto &rectangle = std::get<scene::Rectangle>(body.shape);
        edges.push_back(rectangle.corner[d]);
        edges.push_back(rectangle.corner[d] + rectangle.size[d]);
      }
      const double spacing = (box.upper[d] - box.lower[d]) / cells[d];
      // An end closer to another line than a thousandth of a cell would only make a sliver.
      for (const scene::Where &part : parts)
        for (const double x : extent(part, d))
          if (x > box.lower[d] && x < box.upper[d] && !near_any(edges, x, 1e-3 * spacing))
            edges.push_back(x);
      lines[d] = grid_lines(distinct(edges, tolerance), spacing, corners[d], grading, tolerance);
    }
    return keep_inside(bodies, lines);
  }
} // namespace fe
