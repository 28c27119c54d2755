#include "scene/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/reader.h"

namespace scene
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    template <class... F>
    struct Overloaded : F...
    {
      using F::operator()...;
    };
    template <class... F>
    Overloaded(F...) -> Overloaded<F...>;

    [[noreturn]] void refuse(const SourceLocation &place)
    {
      throw BadScene(place.file + ":" + std::to_string(place.line) +
                     ": [[body]] the recorded outline has not been read yet: its polygon must "
                     "replace it first (record/outline_source.h)");
    }

    double distance_to_rectangle(const Rectangle &r, const Point &p)
    {
      const Point half = 0.5 * r.size, centre = r.corner + half;
      const Point outside = (p - centre).cwiseAbs() - half; // negative inside
      return -(outside.cwiseMax(0.).norm() + std::min(outside.maxCoeff(), 0.));
    }

    // Nearest edge of any outline; the sign by the even-odd rule: crossings of a ray to the right.
    double distance_to_polygon(const Polygon &polygon, const Point &p)
    {
      double nearest = infinity;
      bool inside = false;
      for (const Polyline &line : polygon.outlines)
        for (std::size_t i = 0; i < line.size(); ++i)
        {
          const Point &a = line[i], &b = line[(i + 1) % line.size()];
          nearest = std::min(nearest, distance_to_segment(p, a, b));
          if ((a[1] > p[1]) != (b[1] > p[1]) &&
              p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
            inside = !inside;
        }
      return inside ? nearest : -nearest;
    }

    Box box_of(const Body &body)
    {
      const auto around = [](const Point &centre, const double radius) {
        return Box{centre.array() - radius, centre.array() + radius};
      };
      return std::visit(Overloaded{[](const Rectangle &r) {
                                     return Box{r.corner, r.corner + r.size};
                                   },
                                   [&](const Disc &d) { return around(d.centre, d.radius); },
                                   [&](const Ring &r) { return around(r.centre, r.outer_radius); },
                                   [](const Polygon &polygon)
                                   {
                                     Box box{Point::Constant(infinity), Point::Constant(-infinity)};
                                     for (const Polyline &line : polygon.outlines)
                                       for (const Point &p : line)
                                         box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
                                     return box;
                                   },
                                   [&](const RecordedOutline &) -> Box { refuse(body.place); }},
                        body.shape);
    }
  } // namespace

  double signed_distance(const Body &body, const Point &p)
  {
    return std::visit(
        Overloaded{[&](const Rectangle &r) { return distance_to_rectangle(r, p); },
                   [&](const Disc &d) { return d.radius - (p - d.centre).norm(); },
                   [&](const Ring &r)
                   {
                     const double radius = (p - r.centre).norm();
                     return std::min(r.outer_radius - radius, radius - r.inner_radius);
                   },
                   [&](const Polygon &polygon) { return distance_to_polygon(polygon, p); },
                   [&](const RecordedOutline &) -> double { refuse(body.place); }},
        body.shape);
  }

  double signed_distance(const std::vector<Body> &bodies, const Point &p)
  {
    double largest = -infinity;
    for (const Body &body : bodies)
      largest = std::max(largest, signed_distance(body, p));
    return largest;
  }

  Box bounding_box(const std::vector<Body> &bodies)
  {
    Box box{Point::Constant(infinity), Point::Constant(-infinity)};
    for (const Body &body : bodies)
    {
      const Box own = box_of(body);
      box = {box.lower.cwiseMin(own.lower), box.upper.cwiseMax(own.upper)};
    }
    return box;
  }

  bool holds_material(const Box &box, const std::vector<Body> &bodies)
  {
    constexpr int samples = 48;
    for (const Body &body : bodies)
    {
      const Box own = bounding_box({body});
      const Point lower = box.lower.cwiseMax(own.lower), upper = box.upper.cwiseMin(own.upper);
      if ((upper.array() <= lower.array()).any())
        continue;
      for (int i = 0; i < samples * samples; ++i)
      {
        const Point s((i % samples + 0.5) / samples, (i / samples + 0.5) / samples);
        if (signed_distance(body, lower + (upper - lower).cwiseProduct(s)) > 0.)
          return true;
      }
    }
    return false;
  }

  double signed_area(const Polyline &line)
  {
    double twice = 0.;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      // Relative to the first vertex: no cancellation far from the origin.
      const Point a = line[i] - line[0], b = line[(i + 1) % line.size()] - line[0];
      twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * twice;
  }

  double default_bin(const Scene &scene)
  {
    const double cell = scene.domain.spacing().maxCoeff();
    if (scene.growth) // a crystal has no size to divide; its stresses are compared in four cells
      return 4. * cell;
    const Box box = bounding_box(scene.bodies);
    return std::max((box.upper - box.lower).minCoeff() / 20., cell);
  }

  double distance_to_segment(const Point &p, const Point &a, const Point &b)
  {
    return (p - a - along_segment(p, a, b) * (b - a)).norm();
  }

  bool on_symmetry_side(const Domain &domain, const int axis, const Point &X,
                        const double tolerance)
  {
    const auto on = [&](const int upper, const double side)
    {
      return domain.boundary[2 * axis + upper] == Boundary::symmetry &&
             std::abs(X[axis] - side) <= tolerance;
    };
    return on(0, domain.lower[axis]) || on(1, domain.upper()[axis]);
  }

  bool reaches_over_symmetry(const Domain &domain, const Edge edge, const Box &bodies,
                             const double by)
  {
    const auto side = static_cast<int>(edge);
    const int axis = side / 2;
    const double over = side % 2 == 0 ? domain.lower[axis] - bodies.lower[axis]
                                      : bodies.upper[axis] - domain.upper()[axis];
    return domain.boundary[side] == Boundary::symmetry && over > by;
  }

  bool contains(const Where &where, const Box &bodies_box, const Point &X, const double tolerance)
  {
    return std::visit(
        Overloaded{[&](const Edge edge)
                   {
                     const int axis = edge == Edge::left || edge == Edge::right ? 0 : 1;
                     const bool lower = edge == Edge::left || edge == Edge::bottom;
                     const double side = lower ? bodies_box.lower[axis] : bodies_box.upper[axis];
                     return std::abs(X[axis] - side) <= tolerance;
                   },
                   [&](const Segment &s) { return distance_to_segment(X, s.a, s.b) <= tolerance; },
                   [&](const Box &box)
                   {
                     return (X.array() >= box.lower.array() - tolerance).all() &&
                            (X.array() <= box.upper.array() + tolerance).all();
                   }},
        where);
  }
} // namespace scene
