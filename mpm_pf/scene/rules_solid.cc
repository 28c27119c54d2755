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
    // Only expressions that are sound: the others have their error already.
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

  } // namespace

  void viscosity_needs_yield_stress(const Inspection &in)
  {
    if (in.written("solid", "viscosity") && !in.written("solid", "yield_stress"))
      in.add_error(in.at("solid", "viscosity"),
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
            in.add_error(*value, std::string(key) + " of a body without [solid]", "",
                         "add [solid], or remove the key");
          const bool stress = std::string(key) == "initial_stress";
          if (stress ? std::any_of(body.initial_stress->begin(), body.initial_stress->end(), timed)
                     : std::any_of(body.velocity.begin(), body.velocity.end(), timed))
            in.add_error(*value, "an initial value that depends on t", "expressions of X and Y",
                         "remove t");
          if (in.present("growth") && in.present("wall"))
            in.add_error(*value,
                         std::string(key) +
                             " of a crystal that grows between walls: it has material, at rest and "
                             "free of stress, once a wall touches it",
                         "crystals without walls start with a " +
                             std::string(stress ? "stress" : "velocity"),
                         "remove the key, or the walls");
        }
    }
  }

  void supports_hold_something(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().supports.size(); ++i)
    {
      const Support &support = in.scene().supports[i];
      const Value *key = in.draft.supports[i]->find("displacement");
      if (!key || in.errors.about(*key))
        continue;
      if (!support.displacement[0] && !support.displacement[1])
        in.add_error(*key, "both components are free: this support holds nothing",
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
            in.add_error(*key,
                         "the displacement \"" + component->text +
                             "\" is not 0 at t = 0: the "
                             "body would start with a jump",
                         "displacements that start from 0",
                         "multiply by t, or by smooth(t, T) over a time T");
    }
  }

  void displacements_are_of_places_at_the_start(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().supports.size(); ++i)
    {
      const Value *key = in.draft.supports[i]->find("displacement");
      if (!key || in.errors.about(*key))
        continue;
      for (const auto &component : in.scene().supports[i].displacement)
        if (component && any_expression(*component, [](const Function &f)
                                        { return f.depends_on_current_position(); }))
          in.add_error(*key,
                       "the displacement \"" + component->text +
                           "\" depends on where the material is, which the displacement itself "
                           "decides",
                       "displacements of X, Y and t", "write X and Y: where the material started");
    }
  }

  void transfer_keys_are_used(const Inspection &in)
  {
    if (!in.scene().mpm || in.errors.about(in.at("mpm")))
      return;
    const Mpm &mpm = *in.scene().mpm;
    if (in.written("mpm", "flip_fraction") && mpm.transfer != Transfer::flip)
      in.add_error(in.at("mpm", "flip_fraction"),
                   "flip_fraction has no use with transfer = \"" + word(mpm.transfer) + "\"",
                   "flip_fraction with transfer = \"flip\"", "remove it, or set the transfer");
    const bool incremental = mpm.transfer == Transfer::flip || mpm.transfer == Transfer::xpic2;
    if (mpm.stress_update == StressUpdate::first && !incremental)
      in.add_error(in.at("mpm", "stress_update"),
                   "stress_update = \"first\" with transfer = \"" + word(mpm.transfer) +
                       "\", which carries its own velocity gradient",
                   "stress_update = \"first\" with transfer = \"flip\" or \"xpic2\"",
                   "remove it, or set the transfer");
    if (in.written("mpm", "node_mass_floor") && mpm.node_mass_floor > 0. &&
        mpm.stress_update == StressUpdate::first)
      in.add_error(in.at("mpm", "node_mass_floor"),
                   "node_mass_floor has no use with stress_update = \"first\", which ties no nodes",
                   "node_mass_floor with stress_update = \"last\"", "remove it");
    const auto &solid = in.scene().solid;
    const bool locks = in.written("solid", "yield_stress") || (solid && solid->locks());
    const bool averaged = mpm.anti_locking.value_or(locks);
    if (in.written("mpm", "pressure_relaxation") && !averaged)
      in.add_error(in.at("mpm", "pressure_relaxation"),
                   "pressure_relaxation has no use without anti-locking, which is off here",
                   "pressure_relaxation with anti_locking = true",
                   "remove it, or set anti_locking = true");
  }

  void mach_has_a_speed(const Inspection &in)
  {
    if (in.written("mpm", "reference_speed") && !in.written("mpm", "mach"))
      in.add_error(in.at("mpm", "reference_speed"), "reference_speed has no use without mach",
                   "reference_speed with mach", "remove it, or give mach");
    if (in.written("mpm", "mach") && !in.written("mpm", "reference_speed") &&
        !in.present("support") && !in.present("wall"))
      in.add_error(in.at("mpm", "mach"),
                   "a Mach number of what? No support or wall gives a speed to refer to",
                   "mach with supports, walls or reference_speed", "add reference_speed");
  }

  void fe_cells_are_both_given(const Inspection &in)
  {
    if (in.scene().fe && (in.scene().fe->cells[0] == 0) != (in.scene().fe->cells[1] == 0))
      in.add_error(in.at("fe", "cells"), "one number of cells is 0, the other is not",
                   "two numbers, or [0, 0] to follow the domain's cells", "give both");
  }
} // namespace scene
