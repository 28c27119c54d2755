#include "scene/exact_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/geometry.h"

namespace scene
{
  namespace
  {
    constexpr double rounding = 1e-6; // of the size, ten times what was seen

    using Side = std::array<Point, 2>;

    double cross(const Point &a, const Point &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    struct Given
    {
      std::vector<Point> vertices; // sorted by x
      std::vector<Side> sides;
      double tolerance = 0.;
    };

    Given look_at(const std::vector<Polyline> &outlines)
    {
      Given given;
      for (const Polyline &line : outlines)
        for (std::size_t k = 0; k < line.size(); ++k)
        {
          given.vertices.push_back(line[k]);
          given.sides.push_back({line[k], line[(k + 1) % line.size()]});
        }
      if (given.vertices.empty())
        return given;
      std::sort(given.vertices.begin(), given.vertices.end(),
                [](const Point &a, const Point &b) { return a[0] < b[0]; });
      Point lower = given.vertices.front(), upper = lower;
      for (const Point &p : given.vertices)
        lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
      given.tolerance = rounding * (upper - lower).norm();
      return given;
    }

    const Point *nearest_vertex(const Given &given, const Point &p)
    {
      const Point *nearest = nullptr;
      double distance = given.tolerance;
      for (auto v = std::lower_bound(given.vertices.begin(), given.vertices.end(),
                                     p[0] - given.tolerance,
                                     [](const Point &a, const double x) { return a[0] < x; });
           v != given.vertices.end() && (*v)[0] <= p[0] + given.tolerance; ++v)
        if ((*v - p).norm() <= distance)
          distance = (*v - p).norm(), nearest = &*v;
      return nearest;
    }

    Point foot(const Side &side, const Point &p)
    {
      return side[0] + along_segment(p, side[0], side[1]) * (side[1] - side[0]);
    }

    // Where those two of the sides through `p` cross that differ most in direction; without such
    // two, on the nearest side.
    Point crossing(const Given &given, const Point &p)
    {
      std::vector<const Side *> through;
      Point best = p;
      double distance = given.tolerance;
      for (const Side &side : given.sides)
      {
        const Point on = foot(side, p);
        if ((on - p).norm() > given.tolerance)
          continue;
        through.push_back(&side);
        if ((on - p).norm() <= distance)
          distance = (on - p).norm(), best = on;
      }
      double largest = 1e-3; // flatter crossings are found less exactly than they were
      for (std::size_t i = 0; i < through.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
          const Side &a = *through[i], &b = *through[j];
          const Point da = a[1] - a[0], db = b[1] - b[0];
          const double sine = std::abs(cross(da, db)) / (da.norm() * db.norm());
          if (sine <= largest)
            continue;
          largest = sine;
          best = a[0] + cross(b[0] - a[0], db) / cross(da, db) * da;
          for (int axis = 0; axis < 2; ++axis) // a side along an axis to the last digit
            for (const Side *side : {&a, &b})
              if ((*side)[0][axis] == (*side)[1][axis])
                best[axis] = (*side)[0][axis];
        }
      return best;
    }

    Polyline without_repetition(const Polyline &line, const double tolerance)
    {
      Polyline result;
      for (const Point &p : line)
        if (result.empty() || (p - result.back()).norm() > tolerance)
          result.push_back(p);
      while (result.size() > 1 && (result.front() - result.back()).norm() <= tolerance)
        result.pop_back();
      return result;
    }
  } // namespace

  std::vector<Polyline> exact_vertices(std::vector<Polyline> joined,
                                       const std::vector<Polyline> &outlines)
  {
    const Given given = look_at(outlines);
    std::vector<Polyline> result;
    for (Polyline &line : joined)
    {
      for (Point &p : line)
      {
        const Point *vertex = nearest_vertex(given, p);
        p = vertex ? *vertex : crossing(given, p);
      }
      Polyline exact = without_repetition(line, given.tolerance);
      if (exact.size() > 2)
        result.push_back(std::move(exact));
    }
    return result;
  }
} // namespace scene
