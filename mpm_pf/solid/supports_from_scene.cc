#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/geometry.h"
#include "solid/support_builder.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    Motion motion_of(const scene::Support &support)
    {
      Motion motion;
      for (int c = 0; c < 2; ++c)
        if (support.displacement[c])
        {
          motion.displacement[c].emplace(*support.displacement[c]);
          motion.uniform = motion.uniform && !motion.displacement[c]->depends_on_position();
        }
      return motion;
    }

    // Sides of a rigid grip towards material that is not gripped.
    void hold_sides(SupportBuilder &build, const scene::Box &box, const int index)
    {
      for (int axis = 0; axis < 2; ++axis)
        for (const int side : {-1, 1})
        {
          const int along = 1 - axis;
          double from = std::numeric_limits<double>::max(), to = -from;
          for (int k = 0; k <= 400; ++k)
          {
            Point x;
            x[along] = box.lower[along] + k / 400. * (box.upper[along] - box.lower[along]);
            x[axis] = (side > 0 ? box.upper : box.lower)[axis] + side * 0.01 * build.dx;
            if (scene::signed_distance(build.scene.bodies, x) > 1e-6 * build.dx)
              from = std::min(from, x[along]), to = std::max(to, x[along]);
          }
          if (from > to)
            continue;
          HeldLine line;
          line.support = index, line.axis = axis, line.side = side;
          line.initial = (side > 0 ? box.upper : box.lower)[axis];
          line.from = from, line.to = to;
          line.reach = {reach_beyond(build, line, 0), reach_beyond(build, line, 1)};
          build.supports.lines.push_back(line);
        }
    }

    // Material around a corner of the box lies beside one side and behind the line of the other,
    // where no shape function can be folded.
    bool corner_in_material(const SupportBuilder &build, const scene::Box &box)
    {
      for (const double x : {box.lower[0], box.upper[0]})
        for (const double y : {box.lower[1], box.upper[1]})
        {
          // All around it: on the seam of two bodies the distance from the outline is not known.
          double least = std::numeric_limits<double>::max();
          for (const double a : {-0.01, 0.01})
            for (const double b : {-0.01, 0.01})
              least = std::min(least, scene::signed_distance(build.scene.bodies,
                                                             {x + a * build.dx, y + b * build.dx}));
          if (least > build.small())
            return true;
        }
      return false;
    }

    void hold_symmetry(SupportBuilder &build)
    {
      const scene::Domain &domain = build.scene.domain;
      for (const scene::Edge edge :
           {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
      {
        const bool walled = std::any_of(build.scene.walls.begin(), build.scene.walls.end(),
                                        [&](const auto &wall) { return wall.side == edge; });
        if (walled || domain.boundary[static_cast<int>(edge)] != scene::Boundary::symmetry)
          continue;
        HeldLine line;
        line.axis = edge == scene::Edge::left || edge == scene::Edge::right ? 0 : 1;
        line.side = edge == scene::Edge::left || edge == scene::Edge::bottom ? 1 : -1;
        line.initial = line.position = (line.side > 0 ? domain.lower : domain.upper())[line.axis];
        line.from = line.lower = domain.lower[1 - line.axis];
        line.to = line.upper = domain.upper()[1 - line.axis];
        line.held = {line.axis == 0, line.axis == 1};
        build.supports.lines.push_back(line);
      }
    }

    // Points of rigid grips behind the others, in their old order.
    void set_aside(Points &points, const std::vector<Grip> &grips)
    {
      unsigned mask = 0;
      for (const Grip &grip : grips)
        mask |= 1u << grip.region;
      std::vector<std::uint32_t> order(points.size());
      for (std::size_t p = 0; p < order.size(); ++p)
        order[p] = static_cast<std::uint32_t>(p);
      const auto middle =
          std::stable_partition(order.begin(), order.end(),
                                [&](const std::uint32_t p) { return !(points.regions[p] & mask); });
      Array<double> scratch;
      reorder(points, order, scratch, 1);
      points.active = static_cast<std::size_t>(middle - order.begin());
    }
  } // namespace

  void place_mirrors(Supports &supports, Grid &grid)
  {
    for (HeldLine &side : supports.lines)
    {
      if (side.support >= 0)
        continue;
      side.reflects = std::none_of(supports.lines.begin(), supports.lines.end(),
                                   [&](const HeldLine &other)
                                   {
                                     return other.support >= 0 && other.axis == side.axis &&
                                            std::abs(other.initial - side.initial) < 0.5 * grid.dx;
                                   });
      if (side.reflects)
        grid.mirrors.push_back({side.axis, side.side > 0 ? 0 : grid.cells[side.axis], side.side});
    }
  }

  void hold_box(SupportBuilder &build, const scene::Support &asked, const int index)
  {
    Support &support = build.supports.all[index];
    const auto &box = std::get<scene::Box>(asked.where);
    if (build.regions >= 16)
      refuse(asked, "is the 17th box; at most 16 boxes can be held");
    const int region = build.regions++;
    const bool rigid = support.motion.uniform && support.motion.holds(0) &&
                       support.motion.holds(1) && !corner_in_material(build, box);
    Point lower = box.upper, upper = box.lower;
    const Fraction fraction(build.scene.domain);
    bool any = false;
    for (std::size_t p = 0; p < build.points.active; ++p)
    {
      const Point X = fraction.initial(build.points, p);
      if (!scene::contains(asked.where, build.box, X, build.small()))
        continue;
      build.points.regions[p] = static_cast<std::uint16_t>(build.points.regions[p] | 1u << region);
      lower = lower.cwiseMin(X), upper = upper.cwiseMax(X), any = true;
    }
    if (!any)
      refuse(asked, "holds a box without a material point");
    support.middle = 0.5 * (lower + upper);
    support.corners = {lower, upper, {lower[0], upper[1]}, {upper[0], lower[1]}};
    if (!rigid)
    {
      build.supports.driven.push_back({index, region, box, open_sides(build.scene, asked), {}});
      return;
    }
    const int grip = static_cast<int>(build.supports.grips.size());
    build.supports.grips.push_back({index, box, region});
    for (auto &outline : build.tracers.outlines)
      for (Tracer &tracer : outline)
        if (scene::contains(asked.where, build.box, tracer.X, build.small()))
          tracer.grip = grip;
    hold_sides(build, box, index);
  }

  Supports make_supports(const scene::Scene &scene, Points &points, Tracers &tracers)
  {
    Supports supports;
    const scene::Box box = scene::bounding_box(scene.bodies);
    SupportBuilder build{scene, points, tracers, supports, box, scene.domain.spacing()[0]};
    hold_symmetry(build);
    for (std::size_t k = 0; k < scene.supports.size(); ++k)
    {
      const scene::Support &asked = scene.supports[k];
      Support support;
      support.name = asked.name, support.place = asked.place, support.motion = motion_of(asked);
      supports.all.push_back(std::move(support));
      if (std::holds_alternative<scene::Box>(asked.where))
        hold_box(build, asked, static_cast<int>(k));
      else
        hold_edge(build, asked, static_cast<int>(k));
    }
    add_walls(supports, scene);
    set_aside(points, supports.grips);
    return supports;
  }
} // namespace solid
