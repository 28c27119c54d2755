#include "scene/interface_distance.h"

#include <array>
#include <cmath>

namespace scene
{
  namespace
  {
    /// Outward normals of the sides that an edge from a to b lies on, as a sum; zero for none.
    class Sides
    {
    public:
      Sides(const Domain &domain, const Box &bodies)
          : box{domain.lower, domain.upper()}, tolerance(1e-6 * domain.spacing().minCoeff())
      {
        // The neighbour across a periodic side is the body's own other end, if it reaches there.
        for (int axis = 0; axis < 2; ++axis)
        {
          const bool through = bodies.lower[axis] <= box.lower[axis] + tolerance &&
                               bodies.upper[axis] >= box.upper[axis] - tolerance;
          for (const int end : {0, 1})
            counts[2 * axis + end] =
                domain.boundary[2 * axis + end] != Boundary::periodic || through;
        }
      }

      Point normal(const Point &a, const Point &b) const
      {
        Point n = Point::Zero();
        for (int axis = 0; axis < 2; ++axis)
        {
          const auto on = [&](const double side) {
            return std::abs(a[axis] - side) <= tolerance && std::abs(b[axis] - side) <= tolerance;
          };
          if (counts[2 * axis] && on(box.lower[axis]))
            n[axis] = -1.;
          if (counts[2 * axis + 1] && on(box.upper[axis]))
            n[axis] = 1.;
        }
        return n;
      }

    private:
      Box box;
      double tolerance;
      std::array<bool, 4> counts{}; // as Edge: left, right, bottom, top
    };

    // Each open edge moves along its normal by `far`; its ends follow along the neighbours' lines.
    Polyline opened(const Polyline &line, const Sides &sides, const double far)
    {
      Polyline moved;
      const std::size_t n = line.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        const Point in = sides.normal(line[(i + n - 1) % n], line[i]);
        const Point out = sides.normal(line[i], line[(i + 1) % n]);
        if (in.isZero() && out.isZero())
          moved.push_back(line[i]);
        else if (in.isZero() || out.isZero())
        {
          const Point beyond = line[i] + far * (in + out);
          moved.push_back(in.isZero() ? line[i] : beyond);
          moved.push_back(in.isZero() ? beyond : line[i]);
        }
        else
          moved.push_back(line[i] + far * (in == out ? in : Point(in + out)));
      }
      return moved;
    }

    // A circle about a point of the side is its own mirror image, and the way from a point of the
    // domain out to a circle about a point beyond does not lead over the side.
    bool is_as_near_in_the_domain(const Body &body, const Domain &domain, const Edge side,
                                  const double tolerance)
    {
      const auto *disc = std::get_if<Disc>(&body.shape);
      const auto *ring = std::get_if<Ring>(&body.shape);
      if (!disc && !ring)
        return false;
      const int k = static_cast<int>(side), axis = k / 2;
      const double centre = (disc ? disc->centre : ring->centre)[axis];
      const double beyond =
          k % 2 == 0 ? domain.lower[axis] - centre : centre - domain.upper()[axis];
      return disc ? beyond >= -tolerance : std::abs(beyond) <= tolerance;
    }

    // What reaches over a symmetry side is no part of the crystal: its own mirror image is there.
    void cut_at_symmetry_sides(std::vector<Body> &bodies, const Domain &domain,
                               const double spacing)
    {
      const double tolerance = 1e-6 * domain.spacing().minCoeff();
      for (Body &body : bodies)
        for (const Edge side : {Edge::left, Edge::right, Edge::bottom, Edge::top})
          if (reaches_over_symmetry(domain, side, bounding_box({body}), tolerance) &&
              !is_as_near_in_the_domain(body, domain, side, tolerance))
          {
            body.shape = Polygon{outline({body}, domain, spacing)};
            break;
          }
    }
  } // namespace

  std::vector<Body> opened_at_sides(std::vector<Body> bodies, const Domain &domain)
  {
    const double far = 10. * domain.size.norm();
    const Sides sides(domain, bounding_box(bodies));
    for (Body &body : bodies)
    {
      if (const auto *r = std::get_if<Rectangle>(&body.shape))
      {
        const Point a = r->corner, c = a + r->size, b(c[0], a[1]), d(a[0], c[1]);
        if (!(sides.normal(a, b).isZero() && sides.normal(b, c).isZero() &&
              sides.normal(c, d).isZero() && sides.normal(d, a).isZero()))
          body.shape = Polygon{{opened({a, b, c, d}, sides, far)}};
      }
      else if (auto *polygon = std::get_if<Polygon>(&body.shape))
        for (Polyline &line : polygon->outlines)
          line = opened(line, sides, far);
    }
    return bodies;
  }

  InterfaceDistance::InterfaceDistance(std::vector<Body> all, const Domain &domain,
                                       const double flat, const double spacing)
      : depth(flat)
  {
    cut_at_symmetry_sides(all, domain, spacing);
    bodies = opened_at_sides(std::move(all), domain);
    joined = joined_where_they_touch(bodies, spacing);
  }

  double InterfaceDistance::operator()(const Point &p) const
  {
    // Outside the nearest body counts; inside, the seams between bodies do not.
    const double nearest = signed_distance(bodies, p);
    return joined && nearest > -1e-6 * depth && nearest < depth ? signed_distance(*joined, p)
                                                                : nearest;
  }
} // namespace scene
