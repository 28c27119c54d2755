// The outline of a union of bodies: each body as a polygon (curves subdivided), joined by
// Boost.Geometry, its vertices made exact, and all edges subdivided to the wanted spacing.
#include <cmath>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "scene/exact_vertices.h"
#include "scene/geometry.h"

namespace scene
{
  namespace
  {
    namespace bg = boost::geometry;
    using Vertex = bg::model::d2::point_xy<double>;
    using Area = bg::model::polygon<Vertex, false, false>; // counter-clockwise, not closed
    using Areas = bg::model::multi_polygon<Area>;

    Polyline circle(const Point &centre, const double radius, const double spacing)
    {
      constexpr double turn = 6.28318530717958647692;
      const int n = std::max(16, 4 * static_cast<int>(std::ceil(turn * radius / spacing / 4.)));
      Polyline line(n);
      for (int i = 0; i < n; ++i)
        line[i] = centre + radius * Point(std::cos(turn * i / n), std::sin(turn * i / n));
      return line;
    }

    std::vector<Polyline> outlines_of(const Body &body, const double spacing)
    {
      if (const auto *r = std::get_if<Rectangle>(&body.shape))
        return {{r->corner, r->corner + Point(r->size[0], 0.), r->corner + r->size,
                 r->corner + Point(0., r->size[1])}};
      if (const auto *d = std::get_if<Disc>(&body.shape))
        return {circle(d->centre, d->radius, spacing)};
      if (const auto *r = std::get_if<Ring>(&body.shape))
        return {circle(r->centre, r->outer_radius, spacing),
                circle(r->centre, r->inner_radius, spacing)};
      if (const auto *polygon = std::get_if<Polygon>(&body.shape))
        return polygon->outlines;
      bounding_box({body}); // throws for an outline that has not been read yet
      return {};
    }

    // Boost.Geometry takes coordinates for equal that differ by less than some 1e-16, whatever
    // their size: outlines go to it in units of the power of two next to their extent, which
    // changes no digit. Nanometres would be no outline at all.
    double unit_of(const std::vector<Polyline> &lines)
    {
      double extent = 0.;
      for (const Polyline &line : lines)
        for (const Point &p : line)
          extent = std::max(extent, p.cwiseAbs().maxCoeff());
      return extent > 0. ? std::exp2(std::ilogb(extent)) : 1.;
    }

    Areas areas_of(const Polyline &line, const double unit)
    {
      Area area;
      for (const Point &p : line)
        bg::append(area.outer(), Vertex(p[0] / unit, p[1] / unit));
      bg::correct(area);
      return {area};
    }

    // One area, unlike none, passes unchanged: Boost would round its vertices for nothing.
    template <class Join>
    Areas joined(const std::vector<Areas> &parts, const Join &join)
    {
      Areas sum;
      for (const Areas &part : parts)
      {
        Areas next;
        if (sum.empty())
          next = part;
        else
          join(sum, part, next);
        sum = std::move(next);
      }
      return sum;
    }

    // Even-odd rule: an outline inside another one is a hole, one inside a hole an island.
    Areas areas_of(const Body &body, const double spacing, const double unit)
    {
      Areas sum;
      for (const Polyline &line : outlines_of(body, spacing))
      {
        Areas next;
        bg::sym_difference(sum, areas_of(line, unit), next);
        sum = std::move(next);
      }
      return sum;
    }

    template <class Ring>
    Polyline line_of(const Ring &ring, const double unit)
    {
      Polyline line;
      for (const Vertex &v : ring)
        line.emplace_back(v.x() * unit, v.y() * unit);
      return line;
    }

    Polyline subdivided(const Polyline &corners, const double spacing)
    {
      Polyline line;
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing - 1e-9)));
        for (int k = 0; k < parts; ++k)
          line.push_back(a + (b - a) * (static_cast<double>(k) / parts));
      }
      return line;
    }

    Areas union_of(const std::vector<Body> &bodies, const double spacing, const double unit)
    {
      std::vector<Areas> parts;
      for (const Body &body : bodies)
        parts.push_back(areas_of(body, spacing, unit));
      return joined(parts,
                    [](const Areas &a, const Areas &b, Areas &both) { bg::union_(a, b, both); });
    }

    std::vector<Polyline> outlines_of(const std::vector<Body> &bodies, const double spacing)
    {
      std::vector<Polyline> lines;
      for (const Body &body : bodies)
        for (Polyline &line : outlines_of(body, spacing))
          lines.push_back(std::move(line));
      return lines;
    }

    std::vector<Polyline> lines_of(const Areas &areas, const double unit)
    {
      std::vector<Polyline> lines;
      for (const Area &area : areas)
      {
        lines.push_back(line_of(area.outer(), unit));
        for (const auto &hole : area.inners())
          lines.push_back(line_of(hole, unit));
      }
      return lines;
    }

    std::vector<Polyline> subdivided(std::vector<Polyline> lines, const double spacing)
    {
      for (Polyline &line : lines)
        line = subdivided(line, spacing);
      return lines;
    }

    // The plane within the symmetry sides; on other sides it reaches beyond the bodies, not far:
    // Boost rounds to a part of the whole.
    Box within_symmetry(const Box &bodies, const Domain &domain)
    {
      const Point margin = 0.1 * (bodies.upper - bodies.lower);
      Box box{bodies.lower - margin, bodies.upper + margin};
      for (int axis = 0; axis < 2; ++axis)
      {
        if (domain.boundary[2 * axis] == Boundary::symmetry)
          box.lower[axis] = std::max(box.lower[axis], domain.lower[axis]);
        if (domain.boundary[2 * axis + 1] == Boundary::symmetry)
          box.upper[axis] = std::min(box.upper[axis], domain.upper()[axis]);
      }
      return box;
    }

    // What lies beyond a symmetry side by rounding, or just before it, lies on it.
    void snap(std::vector<Polyline> &lines, const Box &window, const double tolerance)
    {
      for (Polyline &line : lines)
        for (Point &p : line)
          for (int axis = 0; axis < 2; ++axis)
            for (const double side : {window.lower[axis], window.upper[axis]})
              if (std::abs(p[axis] - side) <= tolerance)
                p[axis] = side;
    }

    bool any_touch(const std::vector<Body> &bodies)
    {
      for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
          const Box a = bounding_box({bodies[i]}), b = bounding_box({bodies[j]});
          const double slack = 1e-9 * (a.upper - a.lower).norm();
          if ((a.lower.array() <= b.upper.array() + slack).all() &&
              (b.lower.array() <= a.upper.array() + slack).all())
            return true;
        }
      return false;
    }
  } // namespace

  std::vector<Polyline> union_outline(const std::vector<Body> &bodies, const double spacing)
  {
    const std::vector<Polyline> given = outlines_of(bodies, spacing);
    const double unit = unit_of(given);
    return exact_vertices(lines_of(union_of(bodies, spacing, unit), unit), given);
  }

  std::optional<Body> joined_where_they_touch(const std::vector<Body> &bodies, const double spacing)
  {
    if (!any_touch(bodies))
      return {};
    return Body{{}, Polygon{union_outline(bodies, spacing)}, {}, {}, {}};
  }

  std::vector<Polyline> outline(const std::vector<Body> &bodies, const double spacing)
  {
    return subdivided(union_outline(bodies, spacing), spacing);
  }

  std::vector<Polyline> outline(const std::vector<Body> &bodies, const Domain &domain,
                                const double spacing)
  {
    const Box all = bounding_box(bodies), kept = within_symmetry(all, domain);
    if ((all.lower.array() >= kept.lower.array()).all() &&
        (all.upper.array() <= kept.upper.array()).all())
      return outline(bodies, spacing);
    if ((kept.upper.array() <= kept.lower.array()).any())
      return {};
    const Polyline window{
        kept.lower, {kept.upper[0], kept.lower[1]}, kept.upper, {kept.lower[0], kept.upper[1]}};
    std::vector<Polyline> given = outlines_of(bodies, spacing);
    given.push_back(window);
    const double unit = unit_of(given);
    Areas inside;
    bg::intersection(union_of(bodies, spacing, unit), areas_of(window, unit), inside);
    std::vector<Polyline> lines = exact_vertices(lines_of(inside, unit), given);
    snap(lines, kept, 1e-6 * (all.upper - all.lower).norm());
    return subdivided(lines, spacing);
  }

  double shared_area(const Polyline &a, const Polyline &b)
  {
    const double unit = unit_of({a, b});
    Areas both;
    bg::intersection(areas_of(a, unit), areas_of(b, unit), both);
    return bg::area(both) * unit * unit;
  }

  bool crosses_itself(const Polyline &line)
  {
    for (std::size_t k = 0; k < line.size(); ++k)
    {
      const Point &at = line[(k + 1) % line.size()];
      const Point in = at - line[k], out = line[(k + 2) % line.size()] - at;
      const double turn = in[0] * out[1] - in[1] * out[0];
      if (in.dot(out) < 0. && std::abs(turn) <= 1e-12 * in.norm() * out.norm())
        return true; // a spike, back along the side that it came
    }
    const double unit = unit_of({line});
    bg::model::ring<Vertex, false, false> ring;
    for (const Point &p : line)
      bg::append(ring, Vertex(p[0] / unit, p[1] / unit));
    return bg::intersects(ring);
  }
} // namespace scene
