#include "scene/body_sizes.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"

namespace scene
{
  namespace
  {
    double mean_width(const Polygon &polygon)
    {
      double area = 0., perimeter = 0.;
      for (const Polyline &line : polygon.outlines)
      {
        area += signed_area(line);
        for (std::size_t k = 0; k < line.size(); ++k)
          perimeter += (line[(k + 1) % line.size()] - line[k]).norm();
      }
      return perimeter > 0. ? 2. * std::abs(area) / perimeter : 0.;
    }

    bool is_held_whole(const Box &body, const std::vector<Support> &supports)
    {
      return std::any_of(supports.begin(), supports.end(),
                         [&](const Support &support) {
                           return support.displacement[0] && support.displacement[1] &&
                                  covers(support, body);
                         });
    }

    BodySizes sizes_of(const std::vector<Body> &bodies, const std::vector<Support> &holding)
    {
      BodySizes sizes;
      for (const Body &body : bodies)
      {
        if (std::holds_alternative<RecordedOutline>(body.shape))
          continue; // its size is not known before it is read
        const Box box = bounding_box({body});
        if (is_held_whole(box, holding))
          continue;
        const Point side = box.upper - box.lower;
        double thickness = side.minCoeff();
        if (const auto *ring = std::get_if<Ring>(&body.shape))
          thickness = ring->outer_radius - ring->inner_radius;
        if (const auto *polygon = std::get_if<Polygon>(&body.shape))
          thickness = std::min(thickness, mean_width(*polygon));
        sizes.thinnest = sizes.thinnest > 0. ? std::min(sizes.thinnest, thickness) : thickness;
        sizes.longest = std::max(sizes.longest, side.maxCoeff());
      }
      return sizes;
    }
  } // namespace

  bool covers(const Support &support, const Box &bodies)
  {
    const auto *region = std::get_if<Box>(&support.where);
    const double tolerance = 1e-9 * (bodies.upper - bodies.lower).maxCoeff();
    return region && (bodies.lower - region->lower).minCoeff() >= -tolerance &&
           (region->upper - bodies.upper).minCoeff() >= -tolerance;
  }

  BodySizes sizes_to_resolve(const Scene &s)
  {
    const BodySizes free = sizes_of(s.bodies, s.supports);
    return free.thinnest > 0. ? free : sizes_of(s.bodies, {});
  }

  std::array<std::vector<double>, 2> ends_of_held_segments(const Scene &s)
  {
    std::array<std::vector<double>, 2> ends;
    for (const Support &support : s.supports)
      if (const auto *segment = std::get_if<Segment>(&support.where))
        for (int axis = 0; axis < 2; ++axis)
          if (segment->a[1 - axis] == segment->b[1 - axis])
            for (const double end : {segment->a[axis], segment->b[axis]})
              ends[static_cast<std::size_t>(axis)].push_back(end - s.domain.lower[axis]);
    return ends;
  }
} // namespace scene
