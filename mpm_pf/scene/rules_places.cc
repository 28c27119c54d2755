// Rules about where supports and loads are.
#include <algorithm>
#include <cmath>

#include "scene/choices.h"
#include "scene/expression.h"
#include "scene/geometry.h"
#include "scene/rules_list.h"

namespace scene
{
  namespace
  {
    // Does any part of the segment lie on the outline?
    bool touches(const Segment &segment, const Scene &scene, const double tolerance)
    {
      constexpr int samples = 400;
      for (int i = 0; i <= samples; ++i)
      {
        const Point p = segment.a + (segment.b - segment.a) * (static_cast<double>(i) / samples);
        if (std::abs(signed_distance(scene.bodies, p)) <= tolerance)
          return true;
      }
      return false;
    }

    // How far the outline follows a side of the bodies' box; a disc touches it in a point only.
    double contact_length(const Edge edge, const Scene &scene, const Box &box,
                          const double tolerance)
    {
      const int along = edge == Edge::left || edge == Edge::right ? 1 : 0;
      double length = 0.;
      // However large a body is against the cells, its curves need no more than this.
      const double spacing =
          std::max(scene.domain.spacing().minCoeff(), (box.upper - box.lower).norm() / 2000.);
      for (const Polyline &line : outline(scene.bodies, spacing))
        for (std::size_t i = 0; i < line.size(); ++i)
        {
          const Point &a = line[i], &b = line[(i + 1) % line.size()];
          if (contains(edge, box, a, tolerance) && contains(edge, box, b, tolerance))
            length += std::abs(b[along] - a[along]);
        }
      return length;
    }

    // Empty if the place holds material, else what is wrong.
    std::string absence(const Where &where, const Scene &scene)
    {
      const double tolerance = 1e-6 * scene.domain.spacing().minCoeff();
      if (const auto *segment = std::get_if<Segment>(&where))
        return (segment->b - segment->a).norm() > 0. && touches(*segment, scene, 100. * tolerance)
                   ? ""
                   : "no part of the outline lies on this segment";
      if (const auto *box = std::get_if<Box>(&where))
        return holds_material(*box, scene.bodies) ? "" : "there is no material in this region";
      const Edge edge = std::get<Edge>(where);
      const Box box = bounding_box(scene.bodies);
      if (reaches_over_symmetry(scene.domain, edge, box, tolerance))
        return "the bodies reach over the domain's " + word(edge) +
               " side, a symmetry side that cuts their " + word(edge) + " edge off";
      return contact_length(edge, scene, box, tolerance) > 0.
                 ? ""
                 : "the bodies have no " + word(edge) + " edge: their outline meets the " +
                       word(edge) + " side of their bounding box in a point only";
    }

    void check_place(const Where &where, const Value &at, const Inspection &in)
    {
      const std::string wrong = absence(where, in.scene());
      if (wrong.empty())
        return;
      const Box box = bounding_box(in.scene().bodies);
      const auto pair = [](const Point &p)
      { return "(" + number_text(p[0]) + ", " + number_text(p[1]) + ")"; };
      for (const char *key : {"on", "segment", "region"})
        if (const Value *value = at.find(key))
          in.add_error(*value, wrong,
                       "a place where material starts; the bodies reach from " + pair(box.lower) +
                           " to " + pair(box.upper),
                       "correct the coordinates, or name a region of the material");
    }

    bool same_place(const Where &a, const Where &b)
    {
      if (a.index() != b.index())
        return false;
      if (const auto *edge = std::get_if<Edge>(&a))
        return *edge == std::get<Edge>(b);
      if (const auto *s = std::get_if<Segment>(&a))
        return s->a == std::get<Segment>(b).a && s->b == std::get<Segment>(b).b;
      return std::get<Box>(a).lower == std::get<Box>(b).lower &&
             std::get<Box>(a).upper == std::get<Box>(b).upper;
    }

    // Do two boxes overlap by more than rounding where material is?
    bool share_material(const Box &a, const Box &b, const std::vector<Body> &bodies,
                        const double tolerance)
    {
      const Box both{a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)};
      return ((both.upper - both.lower).array() > tolerance).all() && holds_material(both, bodies);
    }

    // Do two displacements have the same values, in whatever words?
    bool same_motion(const Expression &a, const Expression &b, const Inspection &in)
    {
      if (a.text == b.text)
        return true;
      if (!in.geometry_known || in.errors.about(*in.draft.root.find("support")))
        return false;
      const Function first(a), second(b);
      const Box box = bounding_box(in.scene().bodies);
      double largest = 0., apart = 0.;
      for (const double s : {0., 0.37, 1.})
        for (const double r : {0., 0.59, 1.})
          for (int k = 0; k <= 8; ++k)
          {
            const Point X = box.lower + Point(s, r).cwiseProduct(box.upper - box.lower);
            const Argument at{X, X, in.scene().clock.end * k / 8.};
            largest = std::max({largest, std::abs(first(at)), std::abs(second(at))});
            apart = std::max(apart, std::abs(first(at) - second(at)));
          }
      return apart <= 1e-12 * largest;
    }

    // Do two places have more than a corner of the outline, or than a side of a box, in common?
    bool share_material(const Where &a, const Where &b, const Inspection &in)
    {
      if (!in.geometry_known)
        return false;
      const Scene &scene = in.scene();
      const Box box = bounding_box(scene.bodies);
      const double size = (box.upper - box.lower).norm(), tolerance = 1e-6 * size;
      const auto *first = std::get_if<Box>(&a), *second = std::get_if<Box>(&b);
      if (first && second)
        return share_material(*first, *second, scene.bodies, tolerance);
      for (const Polyline &line : outline(scene.bodies, scene.domain, size / 400.))
        for (std::size_t k = 0; k < line.size(); ++k)
        {
          const Point &next = line[(k + 1) % line.size()];
          const auto in_both = [&](const Point &X)
          { return contains(a, box, X, tolerance) && contains(b, box, X, tolerance); };
          if (in_both(line[k]) && in_both(next)) // a point alone may be where one ends
            return true;
        }
      return false;
    }
  } // namespace

  void loads_meet_material(const Inspection &in)
  {
    // A body in the wrong place would make every load look misplaced.
    if (!in.geometry_known || in.errors.about(*in.draft.root.find("body")))
      return;
    for (std::size_t i = 0; i < in.scene().supports.size(); ++i)
      check_place(in.scene().supports[i].where, *in.draft.supports[i], in);
    for (std::size_t i = 0; i < in.scene().tractions.size(); ++i)
      check_place(in.scene().tractions[i].where, *in.draft.tractions[i], in);
  }

  void supports_do_not_compete(const Inspection &in)
  {
    const auto &supports = in.scene().supports;
    for (std::size_t i = 0; i < supports.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (int d = 0; d < 2; ++d)
        {
          const auto &a = supports[i].displacement[d], &b = supports[j].displacement[d];
          if (a && b &&
              (same_place(supports[i].where, supports[j].where) ||
               (!same_motion(*a, *b, in) &&
                share_material(supports[i].where, supports[j].where, in))))
            in.add_error(*in.draft.supports[i],
                         "\"" + supports[i].name + "\" and \"" + supports[j].name +
                             "\" hold the same component of the same place",
                         "each component once", "remove one, or leave its component \"free\"");
        }
  }

  void tractions_act_on_outlines(const Inspection &in)
  {
    if (!in.geometry_known || in.errors.about(*in.draft.root.find("body")))
      return;
    const Box bodies = bounding_box(in.scene().bodies);
    const double spacing = (bodies.upper - bodies.lower).norm() / 2000.;
    for (std::size_t i = 0; i < in.scene().tractions.size(); ++i)
    {
      const Value *region = in.draft.tractions[i]->find("region");
      const Where &where = in.scene().tractions[i].where;
      if (!region || in.errors.about(*region))
        continue;
      const std::vector<Polyline> lines = outline(in.scene().bodies, spacing);
      const auto runs_through = [&](const Polyline &line)
      {
        return std::any_of(line.begin(), line.end(),
                           [&](const Point &X) { return contains(where, bodies, X, 0.); });
      };
      if (std::none_of(lines.begin(), lines.end(), runs_through))
        in.add_error(*region, "no part of the outline runs through this region",
                     "a box around the loaded part of the outline",
                     "a traction is a force per length of outline; for a force on all material "
                     "write [body_force]");
    }
  }
} // namespace scene
