#include <algorithm>
#include <limits>
#include <string>

#include "scene/geometry.h"
#include "scene/reader.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    [[noreturn]] void refuse(const scene::Support &support, const std::string &cause)
    {
      throw scene::BadScene(support.place.file + ":" + std::to_string(support.place.line) +
                            ": support \"" + support.name + "\" " + cause);
    }

    struct Builder
    {
      const scene::Scene &scene;
      Points &points;
      Tracers &tracers;
      Supports &supports;
      scene::Box box;
      double dx;
      int regions = 0, edges = 0;

      bool material(const Point &x) const
      {
        return scene::signed_distance(scene.bodies, x) > -1e-9 * dx;
      }
      double small() const { return 1e-6 * dx; }
    };

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

    std::array<bool, 2> held(const Motion &motion)
    {
      return {motion.holds(0), motion.holds(1)};
    }

    // The straight line that an edge or segment lies on: axis, coordinate, side of the material.
    HeldLine straight(const Builder &build, const scene::Support &asked)
    {
      HeldLine line;
      if (const auto *edge = std::get_if<scene::Edge>(&asked.where))
      {
        line.axis = *edge == scene::Edge::left || *edge == scene::Edge::right ? 0 : 1;
        line.side = *edge == scene::Edge::left || *edge == scene::Edge::bottom ? 1 : -1;
        line.initial = line.side > 0 ? build.box.lower[line.axis] : build.box.upper[line.axis];
        return line;
      }
      const auto &segment = std::get<scene::Segment>(asked.where);
      const Point along = segment.b - segment.a;
      line.axis = std::abs(along[0]) > std::abs(along[1]) ? 1 : 0;
      if (std::abs(along[line.axis]) > build.small())
        refuse(asked, "is on a slanted segment; allowed are segments along x or y, or a box of "
                      "material: in = [[x, y], [x, y]]");
      line.initial = segment.a[line.axis];
      const Point middle = 0.5 * (segment.a + segment.b);
      const Point step = 0.01 * build.dx * Point::Unit(line.axis);
      line.side = build.material(middle + step) ? 1 : -1;
      return line;
    }

    // An edge across the domain's lines may bend only as much as a straight fold can stand for.
    void refuse_bending(const Builder &build, const scene::Support &asked, const Support &support,
                        const HeldLine &line)
    {
      if (support.motion.uniform || !support.motion.holds(line.axis))
        return;
      for (int k = 0; k <= 20; ++k)
      {
        double lowest = std::numeric_limits<double>::max(), highest = -lowest;
        for (const Point &X : support.corners)
        {
          const double u = support.motion.at(X, X, build.scene.clock.end * k / 20.)[line.axis];
          lowest = std::min(lowest, u), highest = std::max(highest, u);
        }
        if (highest - lowest > 0.25 * build.dx)
          refuse(asked, "bends its edge by more than a quarter of a cell; hold a box of material "
                        "two cells deep instead");
      }
    }

    // Where the outline goes on straight beyond an end, the line ends where it was asked to, not at
    // the last tracer before that, and holds no more than half a cell beyond.
    void end_line(const Builder &build, const scene::Support &asked, HeldLine &line)
    {
      const int along = 1 - line.axis;
      for (const int end : {0, 1})
      {
        const int outwards = end == 0 ? -1 : 1;
        double &place = end == 0 ? line.from : line.to;
        Point beyond;
        beyond[line.axis] = line.initial + line.side * 0.01 * build.dx;
        beyond[along] = place + outwards * 0.6 * build.dx;
        if (!build.material(beyond))
          continue;
        line.reach[end] = 0.5;
        if (const auto *segment = std::get_if<scene::Segment>(&asked.where))
        {
          const double a = segment->a[along], b = segment->b[along];
          line.overhang[end] =
              std::max(0., outwards * ((end == 0) == (a < b) ? a - place : b - place));
          place += outwards * line.overhang[end];
        }
      }
    }

    void hold_edge(Builder &build, const scene::Support &asked, const int index)
    {
      Support &support = build.supports.all[index];
      HeldLine line = straight(build, asked);
      line.support = index, line.held = held(support.motion);
      const int along = 1 - line.axis;
      std::vector<std::pair<double, Tracer *>> found;
      for (auto &outline : build.tracers.outlines)
        for (Tracer &tracer : outline)
          if (scene::contains(asked.where, build.box, tracer.X, build.small()))
            found.emplace_back(tracer.X[along], &tracer);
      std::sort(found.begin(), found.end(),
                [](const auto &a, const auto &b) { return a.first < b.first; });
      if (found.empty() || found.back().first - found.front().first < 0.25 * build.dx)
        refuse(asked, "holds less of the outline than the half cell (" +
                          std::to_string(0.5 * build.dx) +
                          ") that can be held; name a longer straight piece, or a box of material");
      std::vector<HeldLine> pieces;
      for (const auto &[s, tracer] : found)
      {
        if (pieces.empty() || s > pieces.back().to + 0.75 * build.dx)
        {
          if (build.edges >= 32)
            refuse(asked, "is the 33rd piece of outline; at most 32 can be held");
          line.from = s, line.bit = 1u << build.edges++;
          pieces.push_back(line);
        }
        pieces.back().to = s;
        tracer->lines |= pieces.back().bit;
        support.corners.push_back(tracer->X);
      }
      support.middle = 0.5 * (found.front().second->X + found.back().second->X);
      for (HeldLine &piece : pieces)
      {
        end_line(build, asked, piece);
        if (support.motion.holds(line.axis))
          build.supports.lines.push_back(piece);
        else if (support.motion.holds(along))
          build.supports.edges.push_back({piece, {}});
      }
      refuse_bending(build, asked, support, line);
    }

    // Sides of a rigid grip towards material that is not gripped.
    void hold_sides(Builder &build, const scene::Box &box, const int index)
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
          build.supports.lines.push_back(line);
        }
    }

    // Material around a corner of the box lies beside one side and behind the line of the other,
    // where no shape function can be folded.
    bool corner_in_material(const Builder &build, const scene::Box &box)
    {
      for (const double x : {box.lower[0], box.upper[0]})
        for (const double y : {box.lower[1], box.upper[1]})
          if (scene::signed_distance(build.scene.bodies, {x, y}) > build.small())
            return true;
      return false;
    }

    void hold_box(Builder &build, const scene::Support &asked, const int index)
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
        build.points.regions[p] =
            static_cast<std::uint16_t>(build.points.regions[p] | 1u << region);
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

    void hold_symmetry(Builder &build)
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

  Supports make_supports(const scene::Scene &scene, Points &points, Tracers &tracers)
  {
    Supports supports;
    const scene::Box box = scene::bounding_box(scene.bodies);
    Builder build{scene, points, tracers, supports, box, scene.domain.spacing()[0]};
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
