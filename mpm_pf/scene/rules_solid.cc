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
    // Only expressions that are sound: the others have their complaint already.
    template <class Test>
    bool any_expression(const Expression &e, const Test &test)
    {
      try
      {
        return test(Function(e));
      }
      catch (const BadScene &)
      {
        return false;
      }
    }

    bool timed(const Expression &e)
    {
      return any_expression(e, [](const Function &f) { return f.depends_on_time(); });
    }

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
      return contact_length(edge, scene, bounding_box(scene.bodies), tolerance) > 0.
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
          in.complain(*value, wrong,
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
    // Do two edges or segments have more than a corner of the outline in common?
    bool share_outline(const Where &a, const Where &b, const Inspection &in)
    {
      if (!in.geometry_known || std::holds_alternative<Box>(a) || std::holds_alternative<Box>(b))
        return false;
      const Scene &scene = in.scene();
      const Box box = bounding_box(scene.bodies);
      const double size = (box.upper - box.lower).norm(), tolerance = 1e-6 * size;
      for (const Polyline &line : outline(scene.bodies, scene.domain, size / 400.))
        for (std::size_t k = 0; k < line.size(); ++k)
        {
          const Point X = 0.5 * (line[k] + line[(k + 1) % line.size()]);
          if (contains(a, box, X, tolerance) && contains(b, box, X, tolerance))
            return true;
        }
      return false;
    }
  } // namespace

  void viscosity_needs_yield_stress(const Inspection &in)
  {
    if (in.written("solid", "viscosity") && !in.written("solid", "yield_stress"))
      in.complain(in.at("solid", "viscosity"),
                  "a viscosity without a yield stress: Perzyna's law, Eq. (6), acts on the stress "
                  "above the yield stress",
                  "viscosity together with yield_stress", "add yield_stress, or remove viscosity");
  }

  void initial_state_is_of_a_solid(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().bodies.size(); ++i)
    {
      const Body &body = in.scene().bodies[i];
      for (const char *key : {"velocity", "initial_stress"})
        if (const Value *value = in.draft.bodies[i]->find(key))
        {
          if (!in.present("solid"))
            in.complain(*value, std::string(key) + " of a body without [solid]", "",
                        "add [solid], or remove the key");
          const bool stress = std::string(key) == "initial_stress";
          if (stress ? std::any_of(body.initial_stress->begin(), body.initial_stress->end(), timed)
                     : std::any_of(body.velocity.begin(), body.velocity.end(), timed))
            in.complain(*value, "an initial value that depends on t", "expressions of X and Y",
                        "remove t");
          if (in.present("growth") && in.present("wall"))
            in.complain(*value,
                        std::string(key) +
                            " of a crystal that grows between walls: it has material, at rest and "
                            "free of stress, once a wall touches it",
                        "crystals without walls start with a " +
                            std::string(stress ? "stress" : "velocity"),
                        "remove the key, or the walls");
        }
    }
  }

  void loads_meet_material(const Inspection &in)
  {
    // A body in the wrong place would make every load look misplaced.
    if (!in.geometry_known || in.complaints.about(*in.draft.root.find("body")))
      return;
    for (std::size_t i = 0; i < in.scene().supports.size(); ++i)
      check_place(in.scene().supports[i].where, *in.draft.supports[i], in);
    for (std::size_t i = 0; i < in.scene().tractions.size(); ++i)
      check_place(in.scene().tractions[i].where, *in.draft.tractions[i], in);
  }

  void supports_hold_something(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().supports.size(); ++i)
    {
      const Support &support = in.scene().supports[i];
      const Value *key = in.draft.supports[i]->find("displacement");
      if (!key || in.complaints.about(*key))
        continue;
      if (!support.displacement[0] && !support.displacement[1])
        in.complain(*key, "both components are free: this support holds nothing",
                    "at least one component held", "remove the support, or hold a component");
      if (!in.geometry_known)
        continue;
      const Box box = bounding_box(in.scene().bodies);
      const double size = (box.upper - box.lower).norm();
      for (const auto &component : support.displacement)
        for (const Point &X : {box.lower, box.upper, Point(0.3 * box.lower + 0.7 * box.upper)})
          if (component && any_expression(*component,
                                          [&](const Function &f) {
                                            return std::abs(f({X, X, 0.})) > 1e-9 * size;
                                          }))
            in.complain(*key,
                        "the displacement \"" + component->text +
                            "\" is not 0 at t = 0: the "
                            "body would start with a jump",
                        "displacements that start from 0",
                        "multiply by t, or by smooth(t, T) over a time T");
    }
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
               (a->text != b->text && share_outline(supports[i].where, supports[j].where, in))))
            in.complain(*in.draft.supports[i],
                        "\"" + supports[i].name + "\" and \"" + supports[j].name +
                            "\" hold the same component of the same place",
                        "each component once", "remove one, or leave its component \"free\"");
        }
  }

  void tractions_act_on_outlines(const Inspection &in)
  {
    if (!in.geometry_known || in.complaints.about(*in.draft.root.find("body")))
      return;
    const Box bodies = bounding_box(in.scene().bodies);
    const double spacing = (bodies.upper - bodies.lower).norm() / 2000.;
    for (std::size_t i = 0; i < in.scene().tractions.size(); ++i)
    {
      const Value *region = in.draft.tractions[i]->find("region");
      const Where &where = in.scene().tractions[i].where;
      if (!region || in.complaints.about(*region))
        continue;
      const std::vector<Polyline> lines = outline(in.scene().bodies, spacing);
      const auto runs_through = [&](const Polyline &line)
      {
        return std::any_of(line.begin(), line.end(),
                           [&](const Point &X) { return contains(where, bodies, X, 0.); });
      };
      if (std::none_of(lines.begin(), lines.end(), runs_through))
        in.complain(*region, "no part of the outline runs through this region",
                    "a box around the loaded part of the outline",
                    "a traction is a force per length of outline; for a force on all material "
                    "write [body_force]");
    }
  }

  void transfer_keys_are_used(const Inspection &in)
  {
    if (!in.scene().mpm || in.complaints.about(in.at("mpm")))
      return;
    const Mpm &mpm = *in.scene().mpm;
    if (in.written("mpm", "flip_fraction") && mpm.transfer != Transfer::flip)
      in.complain(in.at("mpm", "flip_fraction"),
                  "flip_fraction has no use with transfer = \"" + word(mpm.transfer) + "\"",
                  "flip_fraction with transfer = \"flip\"", "remove it, or set the transfer");
    const bool incremental = mpm.transfer == Transfer::flip || mpm.transfer == Transfer::xpic2;
    if (mpm.stress_update == StressUpdate::first && !incremental)
      in.complain(in.at("mpm", "stress_update"),
                  "stress_update = \"first\" with transfer = \"" + word(mpm.transfer) +
                      "\", which carries its own velocity gradient",
                  "stress_update = \"first\" with transfer = \"flip\" or \"xpic2\"",
                  "remove it, or set the transfer");
    if (in.written("mpm", "node_mass_floor") && mpm.node_mass_floor > 0. &&
        mpm.stress_update == StressUpdate::first)
      in.complain(in.at("mpm", "node_mass_floor"),
                  "node_mass_floor has no use with stress_update = \"first\", which ties no nodes",
                  "node_mass_floor with stress_update = \"last\"", "remove it");
    const auto &solid = in.scene().solid;
    const bool locks = in.written("solid", "yield_stress") || (solid && solid->locks());
    const bool averaged = mpm.anti_locking.value_or(locks);
    if (in.written("mpm", "pressure_relaxation") && !averaged)
      in.complain(in.at("mpm", "pressure_relaxation"),
                  "pressure_relaxation has no use without anti-locking, which is off here",
                  "pressure_relaxation with anti_locking = true",
                  "remove it, or set anti_locking = true");
  }

  void mach_has_a_speed(const Inspection &in)
  {
    if (in.written("mpm", "reference_speed") && !in.written("mpm", "mach"))
      in.complain(in.at("mpm", "reference_speed"), "reference_speed has no use without mach",
                  "reference_speed with mach", "remove it, or give mach");
    if (in.written("mpm", "mach") && !in.written("mpm", "reference_speed") &&
        !in.present("support") && !in.present("wall"))
      in.complain(in.at("mpm", "mach"),
                  "a Mach number of what? No support or wall gives a speed to refer to",
                  "mach with supports, walls or reference_speed", "add reference_speed");
  }

  void fe_cells_are_both_given(const Inspection &in)
  {
    if (in.scene().fe && (in.scene().fe->cells[0] == 0) != (in.scene().fe->cells[1] == 0))
      in.complain(in.at("fe", "cells"), "one number of cells is 0, the other is not",
                  "two numbers, or [0, 0] to follow the domain's cells", "give both");
  }
} // namespace scene
