// What expressions give and where they meet: looked up at some of the places and times of the run,
// so that a value which is no number is refused with its line and not found in a later step.
#include <algorithm>
#include <cmath>

#include "scene/expression.h"
#include "scene/geometry.h"
#include "scene/rules_list.h"

namespace scene
{
  namespace
  {
    using Places = std::vector<Point>;

    std::vector<double> times(const Inspection &in)
    {
      constexpr int samples = 32;
      std::vector<double> list{0.};
      if (in.present("clock") && !in.errors.about(in.at("clock")))
        for (int k = 1; k <= samples; ++k)
          list.push_back(in.scene().clock.end * k / samples);
      return list;
    }

    // Points inside a body, none of them on a line of symmetry, where an expression in polar
    // coordinates need not be defined and no material point lies.
    Places inside(const Body &body)
    {
      constexpr int samples = 16;
      const Box box = bounding_box({body});
      Places list;
      for (int i = 0; i < samples * samples; ++i)
      {
        const Point s((i % samples + 0.37) / samples, (i / samples + 0.41) / samples);
        const Point X = box.lower + (box.upper - box.lower).cwiseProduct(s);
        if (signed_distance(body, X) > 0.)
          list.push_back(X);
      }
      return list;
    }

    Places inside(const std::vector<Body> &bodies)
    {
      Places list;
      for (const Body &body : bodies)
        for (const Point &X : inside(body))
          list.push_back(X);
      return list;
    }

    // Of a box the material and the outline in it, else the middles of the outline's chords.
    Places places(const Where &where, const Scene &scene)
    {
      const Box box = bounding_box(scene.bodies);
      const double size = (box.upper - box.lower).norm();
      Places all = std::holds_alternative<Box>(where) ? inside(scene.bodies) : Places{}, list;
      for (const Polyline &line : outline(scene.bodies, scene.domain, size / 200.))
        for (std::size_t i = 0; i < line.size(); ++i)
          all.push_back(0.5 * (line[i] + line[(i + 1) % line.size()]));
      std::copy_if(all.begin(), all.end(), std::back_inserter(list),
                   [&](const Point &X) { return contains(where, box, X, 1e-6 * size); });
      return list;
    }

    // The nodes of the mesh, or every so many where it has many.
    Places nodes(const Domain &domain)
    {
      constexpr int samples = 32;
      Places list;
      for (int j = 0; j <= samples; ++j)
        for (int i = 0; i <= samples; ++i)
        {
          const Eigen::Array2d at(std::floor(static_cast<double>(domain.cells[0]) * i / samples),
                                  std::floor(static_cast<double>(domain.cells[1]) * j / samples));
          list.push_back(domain.lower + (at * domain.spacing().array()).matrix());
        }
      return list;
    }

    std::string when(const Function &f, const Argument &at)
    {
      std::string text;
      if (f.depends_on_position())
        text = " at (" + number_text(at.X[0]) + ", " + number_text(at.X[1]) + ")";
      return text + (f.depends_on_time() ? " at t = " + number_text(at.t) : "");
    }

    void check(const Expression &e, const Value *key, Places where, std::vector<double> t,
               const Inspection &in)
    try
    {
      if (!key || in.errors.about(*key))
        return;
      const Function f(e);
      where.resize(f.depends_on_position() ? where.size() : 1, Point::Zero());
      t.resize(f.depends_on_time() ? t.size() : 1);
      for (const double now : t)
        for (const Point &X : where)
          if (const Argument at{X, X, now}; !std::isfinite(f(at)))
            return in.add_error(
                *key, "\"" + e.text + "\" is no finite number" + when(f, at),
                "a finite number wherever and whenever it is needed",
                "keep it off where it is not defined, as in a < b ? c : d; the T of "
                "smooth(t, T) and ramp(t, T) is not negative");
    }
    catch (const BadScene &)
    {
      // The expression has its error already.
    }

    // Is there a point well inside both?
    bool overlap(const Body &a, const Body &b)
    {
      const Box box = bounding_box({a});
      const double slack = 1e-6 * (box.upper - box.lower).norm();
      Places list = inside(a);
      for (const Point &X : inside(b))
        list.push_back(X);
      return std::any_of(list.begin(), list.end(),
                         [&](const Point &X) {
                           return signed_distance(a, X) > slack && signed_distance(b, X) > slack;
                         });
    }

    bool same(const Expression &a, const Expression &b)
    {
      return a.text == b.text;
    }

    bool start_alike(const Body &a, const Body &b)
    {
      if (!std::equal(a.velocity.begin(), a.velocity.end(), b.velocity.begin(), same))
        return false;
      if (!a.initial_stress || !b.initial_stress)
        return !a.initial_stress && !b.initial_stress;
      return std::equal(a.initial_stress->begin(), a.initial_stress->end(),
                        b.initial_stress->begin(), same);
    }

    // sqrt(3/2 s:s) where it is largest of the places looked at, and there.
    std::pair<double, Point> largest_von_mises(const Body &body)
    {
      std::vector<Function> stress;
      for (const Expression &e : *body.initial_stress)
        stress.emplace_back(e);
      std::pair<double, Point> most{0., Point::Zero()};
      for (const Point &X : inside(body))
      {
        const Argument at{X, X, 0.};
        const double xx = stress[0](at), yy = stress[1](at), zz = stress[2](at), xy = stress[3](at);
        const double here = std::sqrt(
            0.5 * ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) +
            3. * xy * xy);
        if (here > most.first)
          most = {here, X};
      }
      return most;
    }

    void check_bodies(const Inspection &in)
    {
      for (std::size_t i = 0; i < in.scene().bodies.size(); ++i)
      {
        const Body &body = in.scene().bodies[i];
        const Places where = inside(body);
        for (const Expression &e : body.velocity)
          check(e, in.draft.bodies[i]->find("velocity"), where, {0.}, in);
        if (body.initial_stress)
          for (const Expression &e : *body.initial_stress)
            check(e, in.draft.bodies[i]->find("initial_stress"), where, {0.}, in);
      }
    }

    void check_loads(const Inspection &in)
    {
      const Scene &scene = in.scene();
      const std::vector<double> t = times(in);
      for (std::size_t i = 0; i < scene.supports.size(); ++i)
        for (const auto &component : scene.supports[i].displacement)
          if (component)
            check(*component, in.draft.supports[i]->find("displacement"),
                  places(scene.supports[i].where, scene), t, in);
      for (std::size_t i = 0; i < scene.tractions.size(); ++i)
      {
        const Traction &load = scene.tractions[i];
        const Value &at = *in.draft.tractions[i];
        const Places where = places(load.where, scene);
        if (load.pressure)
          check(*load.pressure, at.find("pressure"), where, t, in);
        else
          for (const Expression &e : load.traction)
            check(e, at.find("traction"), where, t, in);
      }
      if (scene.body_force)
        for (const Expression &e : scene.body_force->acceleration)
          check(e, &in.at("body_force", "acceleration"), inside(scene.bodies), t, in);
    }
  } // namespace

  void expressions_are_finite(const Inspection &in)
  {
    if (in.present("domain") && !in.errors.about(in.at("domain")))
    {
      if (in.scene().imposed)
        for (const Expression &e : in.scene().imposed->velocity)
          check(e, &in.at("imposed", "velocity"), nodes(in.scene().domain), times(in), in);
      if (in.scene().heat && in.scene().heat->initial)
        check(*in.scene().heat->initial, &in.at("heat", "initial"), nodes(in.scene().domain), {0.},
              in);
    }
    if (!in.geometry_known || in.errors.about(*in.draft.root.find("body")))
      return;
    check_bodies(in);
    check_loads(in);
  }

  void initial_stress_is_within_yield(const Inspection &in)
  {
    const auto &solid = in.scene().solid;
    if (!in.geometry_known || !solid || !solid->yield_stress || solid->viscosity)
      return; // an overstress is what a viscosity lets relax
    for (std::size_t i = 0; i < in.scene().bodies.size(); ++i)
    {
      const Body &body = in.scene().bodies[i];
      const Value *key = in.draft.bodies[i]->find("initial_stress");
      if (!body.initial_stress || !key || in.errors.about(*key))
        continue;
      if (const auto [most, X] = largest_von_mises(body); most > *solid->yield_stress * (1. + 1e-9))
        in.add_error(*key,
                     "its von Mises stress at (" + number_text(X[0]) + ", " + number_text(X[1]) +
                         ") is above the yield stress of " + number_text(*solid->yield_stress) +
                         ", which no state of a rate-independent solid is",
                     "sqrt(3/2 s:s) of xx, yy, zz, xy at most yield_stress",
                     "lower the stress, mind zz (nu (xx + yy) of an elastic plane strain), or give "
                     "the solid a viscosity that lets it relax");
    }
  }

  void overlapping_bodies_start_alike(const Inspection &in)
  {
    if (!in.geometry_known)
      return;
    const auto &bodies = in.scene().bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!start_alike(bodies[i], bodies[j]) && overlap(bodies[i], bodies[j]))
          in.add_error(*in.draft.bodies[i],
                       "\"" + bodies[j].name + "\" and \"" + bodies[i].name +
                           "\" overlap, but their material starts with different velocities or "
                           "stresses",
                       "bodies apart, or the same velocity and initial_stress",
                       "move one, or write the same expressions");
  }
} // namespace scene
