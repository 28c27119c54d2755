#include "outline_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace verify
{
  namespace
  {
    namespace bg = boost::geometry;
    using Vertex = bg::model::d2::point_xy<double>;
    using Area = bg::model::multi_polygon<bg::model::polygon<Vertex>>;

    Area ring(const scene::Polyline &polyline)
    {
      bg::model::polygon<Vertex> polygon;
      for (const auto &p : polyline)
        bg::append(polygon.outer(), Vertex(p[0], p[1]));
      bg::correct(polygon);
      return {polygon};
    }

    /// Even-odd union of the rings: what lies in an odd number of them.
    Area area_of(const Outline &outline)
    {
      Area sum;
      for (const auto &polyline : outline)
        if (polyline.size() > 2)
        {
          Area next;
          bg::sym_difference(sum, ring(polyline), next);
          sum = next;
        }
      return sum;
    }

    double distance(const scene::Point &p, const Outline &outline)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto &line : outline)
        for (std::size_t i = 0; i < line.size(); ++i)
        {
          const scene::Point a = line[i], edge = line[(i + 1) % line.size()] - a;
          const double length = edge.squaredNorm();
          const double s = length > 0. ? std::clamp((p - a).dot(edge) / length, 0., 1.) : 0.;
          nearest = std::min(nearest, (p - a - s * edge).norm());
        }
      return nearest;
    }

    double one_sided(const Outline &from, const Outline &to)
    {
      double largest = 0.;
      for (const auto &line : from)
        for (const auto &p : line)
          largest = std::max(largest, distance(p, to));
      return largest;
    }

    void refuse_empty(const Outline &outline)
    {
      for (const auto &line : outline)
        for (const auto &p : line)
          if (!p.allFinite())
            throw MissingData("an outline vertex is not finite");
      if (std::none_of(outline.begin(), outline.end(), [](const auto &l) { return l.size() > 2; }))
        throw MissingData("the outline is empty");
    }
  } // namespace

  double area(const Outline &outline)
  {
    refuse_empty(outline);
    return bg::area(area_of(outline));
  }

  double perimeter(const Outline &outline)
  {
    refuse_empty(outline);
    double sum = 0.;
    for (const auto &line : outline)
      for (std::size_t i = 0; i < line.size(); ++i)
        sum += (line[(i + 1) % line.size()] - line[i]).norm();
    return sum;
  }

  double side_position(const Outline &outline, const std::string &side, const double level)
  {
    refuse_empty(outline);
    const int across = side == "left" || side == "right" ? 1 : 0; // the coordinate that is held
    const bool smallest = side == "left" || side == "bottom";
    bool met = false;
    double found = 0.;
    for (const auto &line : outline)
      for (std::size_t i = 0; i < line.size(); ++i)
      {
        const scene::Point a = line[i], b = line[(i + 1) % line.size()];
        if ((a[across] - level) * (b[across] - level) > 0. || a[across] == b[across])
          continue;
        const double s = (level - a[across]) / (b[across] - a[across]);
        const double position = a[1 - across] + s * (b[1 - across] - a[1 - across]);
        if (!met || (smallest ? position < found : position > found))
          found = position;
        met = true;
      }
    if (!met)
      throw MissingData("the outline does not reach the level of the side position");
    return found;
  }

  Outline mirrored(const Outline &outline, const std::string &along)
  {
    const int axis = along == "x" ? 0 : 1;
    Outline result = outline;
    for (auto &line : result)
      for (auto &p : line)
        p[axis] = -p[axis];
    return result;
  }

  Outline rotated(const Outline &outline, const double degrees)
  {
    const Eigen::Rotation2Dd turn(degrees * std::acos(-1.) / 180.);
    Outline result = outline;
    for (auto &line : result)
      for (auto &p : line)
        p = turn * p;
    return result;
  }

  Outline shifted(const Outline &outline, const scene::Point &by)
  {
    Outline result = outline;
    for (auto &line : result)
      for (auto &p : line)
        p += by;
    return result;
  }

  double reach(const Outline &outline)
  {
    refuse_empty(outline);
    double largest = 0.;
    for (const auto &line : outline)
      for (const auto &p : line)
        largest = std::max(largest, p.norm());
    return largest;
  }

  scene::Point extreme(const Outline &outline, const std::string &side)
  {
    refuse_empty(outline);
    const int axis = side == "left" || side == "right" ? 0 : 1;
    const double sign = side == "left" || side == "bottom" ? -1. : 1.;
    scene::Point found = outline.front().front();
    for (const auto &line : outline)
      for (const auto &p : line)
        if (sign * (p[axis] - found[axis]) > 0.)
          found = p;
    return found;
  }

  double symmetric_difference(const Outline &a, const Outline &b)
  {
    refuse_empty(a);
    refuse_empty(b);
    Area difference;
    bg::sym_difference(area_of(a), area_of(b), difference);
    return bg::area(difference);
  }

  double hausdorff(const Outline &a, const Outline &b)
  {
    refuse_empty(a);
    refuse_empty(b);
    return std::max(one_sided(a, b), one_sided(b, a));
  }

  double rms_distance(const Outline &a, const Outline &b)
  {
    refuse_empty(a);
    refuse_empty(b);
    double sum = 0.;
    std::size_t count = 0;
    const auto add = [&](const Outline &from, const Outline &to)
    {
      for (const auto &line : from)
        for (const auto &p : line)
          sum += std::pow(distance(p, to), 2), ++count;
    };
    add(a, b), add(b, a);
    return std::sqrt(sum / static_cast<double>(count));
  }
} // namespace verify
