// Held parts of the outline.
#include <algorithm>
#include <limits>

#include "scene/speed.h"
#include "scene/value.h"
#include "solid/support_builder.h"

namespace solid
{
  namespace
  {
    std::array<bool, 2> held(const Motion &motion)
    {
      return {motion.holds(0), motion.holds(1)};
    }

    // The straight line that an edge or segment lies on: axis, coordinate, side of the material.
    HeldLine straight(const SupportBuilder &build, const scene::Support &asked)
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
                      "material: region = {lower = [x, y], upper = [x, y]}");
      line.initial = segment.a[line.axis];
      const Point middle = 0.5 * (segment.a + segment.b);
      const Point step = 0.01 * build.dx * Point::Unit(line.axis);
      line.side = build.material(middle + step) ? 1 : -1;
      return line;
    }

    // An edge across the domain's lines may bend only as much as a straight fold can stand for.
    void refuse_bending(const SupportBuilder &build, const scene::Support &asked,
                        const Support &support, const HeldLine &line)
    {
      if (support.motion.uniform || !support.motion.holds(line.axis))
        return;
      for (const double time : scene::uneven_times(build.scene.clock.end, 200))
      {
        double lowest = std::numeric_limits<double>::max(), highest = -lowest;
        for (const Point &X : support.corners)
        {
          const double u = support.motion.at(X, X, time)[line.axis];
          lowest = std::min(lowest, u), highest = std::max(highest, u);
        }
        if (highest - lowest > 0.25 * build.dx)
          refuse(asked, "bends its edge by more than a quarter of a cell; hold a box of material "
                        "two cells deep instead");
      }
    }

    // Where the outline goes on straight beyond an end, the line ends where it was asked to, not at
    // the last tracer before that, and holds no more than half a cell beyond.
    void end_line(const SupportBuilder &build, const scene::Support &asked, HeldLine &line)
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
        {
          line.reach[end] = reach_beyond(build, line, end);
          continue;
        }
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
  } // namespace

  double reach_beyond(const SupportBuilder &build, const HeldLine &line, const int end)
  {
    constexpr double farthest = 3., stride = 0.05; // cells
    const int along = 1 - line.axis, outwards = end == 0 ? -1 : 1;
    double nearest = 2. * farthest;
    // Within a cell of the line on both sides; farther ones hardly see its nodes.
    for (const double depth : {-0.99, -0.5, -0.01, 0.01, 0.5, 0.99})
    {
      bool parted = false;
      for (double gap = stride; gap < nearest; gap += stride)
      {
        Point x;
        x[line.axis] = line.initial + line.side * depth * build.dx;
        x[along] = (end == 0 ? line.from : line.to) + outwards * gap * build.dx;
        if (!build.material(x))
          parted = true;
        else if (parted)
          nearest = gap;
      }
    }
    return std::max(0.5, 0.5 * nearest - stride);
  }

  void hold_edge(SupportBuilder &build, const scene::Support &asked, const int index)
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
                        scene::number_text(0.5 * build.dx) +
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
} // namespace solid
