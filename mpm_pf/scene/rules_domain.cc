#include <algorithm>
#include <cmath>
#include <map>

#include "scene/choices.h"
#include "scene/geometry.h"
#include "scene/rules_list.h"

namespace scene
{
  namespace
  {
    /// A section and the sections of which at least one must be there for it to mean anything.
    struct Need
    {
      const char *section;
      std::vector<std::string> any_of;
      const char *reason;
    };

    const std::vector<Need> &needs()
    {
      static const std::vector<Need> list{
          {"body", {"solid", "phase_field"}, "bodies are made of a solid or marked by phi"},
          {"solid", {"body"}, "a solid is the material of bodies"},
          {"phase_field", {"body"}, "phi starts from the bodies"},
          {"mpm", {"solid"}, "material points carry a solid"},
          {"fe", {"solid"}, "finite elements carry a solid"},
          {"support", {"solid"}, "a support holds a solid"},
          {"traction", {"solid"}, "a traction pulls a solid"},
          {"body_force", {"solid"}, "a body force accelerates a solid"},
          {"wall", {"solid", "imposed"}, "a wall presses on a solid, or moves with the melt"},
          {"growth", {"phase_field"}, "growth is the right side of Eq. (1) for phi"},
          {"growth", {"heat"}, "growth is driven by theta, Eq. (2)"},
          {"orientation", {"phase_field"}, "the crystal angle lives in the bodies of phi"},
          {"orientation",
           {"growth", "solid", "imposed"},
           "the crystal angle acts on growth and turns with motion"},
          {"noise", {"heat"}, "noise is a random current of heat"},
          {"imposed", {"phase_field", "heat"}, "an imposed motion carries phi or theta"},
          {"advection", {"phase_field", "heat"}, "advection carries phi or theta"},
          {"advection", {"solid", "imposed"}, "without a motion nothing is carried"},
          {"extension", {"solid"}, "it is a solid's velocity that is extended into the melt"},
          {"extension", {"phase_field"}, "the melt begins where phi says"}};
      return list;
    }

    std::string bracketed(const std::vector<std::string> &sections)
    {
      std::string text;
      for (const std::string &section : sections)
        text += (text.empty() ? "[" : " or [") + section + "]";
      return text;
    }
  } // namespace

  void something_happens(const Inspection &in)
  {
    if (!in.present("solid") && !in.present("phase_field") && !in.present("heat"))
      in.add_error(in.draft.root, "nothing happens in this scene",
                   "at least one of [solid], [phase_field], [heat]",
                   "add the section of the module that is meant");
  }

  void sections_are_used(const Inspection &in)
  {
    for (const Need &need : needs())
      if (in.present(need.section) &&
          std::none_of(need.any_of.begin(), need.any_of.end(),
                       [&](const std::string &section) { return in.present(section); }))
        in.add_error(in.at(need.section),
                     std::string("[") + need.section + "] has no use without " +
                         bracketed(need.any_of) + ": " + need.reason,
                     "",
                     std::string("add ") + bracketed(need.any_of) + ", or remove [" + need.section +
                         "]");
  }

  void imposed_or_solid(const Inspection &in)
  {
    if (in.present("imposed") && in.present("solid"))
      in.add_error(in.at("imposed"),
                   "[imposed] and [solid] both say how the body moves: an imposed motion stands "
                   "instead of a solid",
                   "one of them", "remove [imposed] or [solid]");
  }

  void periodic_sides_are_paired(const Inspection &in)
  {
    const auto periodic = [&](const Edge edge)
    { return in.scene().domain.boundary[static_cast<std::size_t>(edge)] == Boundary::periodic; };
    if (periodic(Edge::left) != periodic(Edge::right) ||
        periodic(Edge::bottom) != periodic(Edge::top))
      in.add_error(in.at("domain", "boundary"), "a periodic side faces one that is not",
                   "left and right both periodic, or bottom and top", "make both sides periodic");
  }

  void cells_are_square(const Inspection &in)
  {
    const Domain &domain = in.scene().domain;
    if (!in.present("domain") || in.errors.about(in.at("domain")) ||
        !(in.present("solid") || in.present("growth")))
      return;
    const Point h = domain.spacing();
    if (std::abs(h[0] - h[1]) <= 1e-9 * h.maxCoeff())
      return;
    const double fine = h.minCoeff();
    in.add_error(in.at("domain", "cells"),
                 "cells of " + number_text(h[0]) + " x " + number_text(h[1]) + " are not square",
                 "square cells: the stencils and the step limits of a solid or a growing crystal "
                 "know one cell size",
                 "cells = [" + std::to_string(std::lround(domain.size[0] / fine)) + ", " +
                     std::to_string(std::lround(domain.size[1] / fine)) +
                     "] gives cells of about " + number_text(fine) +
                     "; adjust size if they do not divide it");
  }

  void mesh_holds_stencils(const Inspection &in)
  {
    if (!in.present("domain") || in.errors.about(in.at("domain")) ||
        !(in.present("phase_field") || in.present("heat") || in.present("wall")))
      return;
    const auto &cells = in.scene().domain.cells;
    if (std::min(cells[0], cells[1]) < fewest_cells)
      in.add_error(in.at("domain", "cells"),
                   "read [" + std::to_string(cells[0]) + ", " + std::to_string(cells[1]) +
                       "]: the widest stencil of the fields and walls reaches over more",
                   "at least " + std::to_string(fewest_cells) + " cells each way",
                   "refine the mesh");
  }

  void bodies_lie_in_the_domain(const Inspection &in)
  {
    if (!in.geometry_known)
      return;
    const Domain &domain = in.scene().domain;
    const double slack = 1e-6 * domain.spacing().minCoeff();
    const auto open = [&](const Edge edge)
    { return domain.boundary[static_cast<std::size_t>(edge)] != Boundary::symmetry; };
    for (std::size_t i = 0; i < in.scene().bodies.size(); ++i)
    {
      const Box box = bounding_box({in.scene().bodies[i]});
      const std::array<double, 4> over{
          domain.lower[0] - box.lower[0], box.upper[0] - domain.upper()[0],
          domain.lower[1] - box.lower[1], box.upper[1] - domain.upper()[1]}; // as Edge
      const Value &at = *in.draft.bodies[i];
      if ((box.lower.array() >= domain.upper().array()).any() ||
          (box.upper.array() <= domain.lower.array()).any())
        in.add_error(at, "the body lies outside the domain", "bodies inside the domain",
                     "move the body, or enlarge [domain] size or shift its origin");
      else
        for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
          if (over[static_cast<std::size_t>(edge)] > slack && open(edge))
          {
            in.add_error(at,
                         "the body reaches over the domain's " + word(edge) + " side by " +
                             number_text(over[static_cast<std::size_t>(edge)]),
                         "bodies inside the domain; only a side with boundary = \"symmetry\" "
                         "may cut a body",
                         "enlarge [domain] size, shift its origin, or make the side a symmetry "
                         "side");
            break;
          }
          else if (in.present("solid") && over[static_cast<std::size_t>(edge)] > -slack &&
                   domain.boundary[static_cast<std::size_t>(edge)] == Boundary::periodic)
          {
            in.add_error(at,
                         "the body lies on the periodic side " + word(edge) +
                             ", which carries fields across but no material",
                         "a solid inside the domain; symmetry sides where it is to be confined",
                         "enlarge [domain] size, or make the sides symmetry sides");
            break;
          }
    }
  }

  void coupling_step_is_used(const Inspection &in)
  {
    if (in.written("clock", "step") && !in.present("phase_field") && !in.present("heat"))
      in.add_error(in.at("clock", "step"), "nothing is coupled in this scene",
                   "clock.step with [phase_field] or [heat]",
                   "remove it; [mpm] step_fraction and [fe] load_steps set the solvers' own steps");
  }

  namespace
  {
    // Tables that programs write unasked, or may: their names are free for what they hold only.
    std::string reserved_for(const Probe &probe, const std::vector<Support> &supports)
    {
      if (probe.name == "energy" && !std::holds_alternative<HistoryProbe>(probe.kind))
        return "a history";
      const auto *reaction = std::get_if<ReactionProbe>(&probe.kind);
      for (const Support &support : supports)
        if (probe.name == "reaction " + support.name &&
            !(reaction && reaction->support == support.name))
          return "the reaction of \"" + support.name + "\"";
      return "";
    }
  } // namespace

  void names_are_unique(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
    {
      const std::string holder = reserved_for(in.scene().probes[i], in.scene().supports);
      const Value *key = in.draft.probes[i]->find("name");
      if (!holder.empty() && key)
        in.add_error(*key, "the name \"" + in.scene().probes[i].name + "\" is kept for " + holder,
                     "other names", "change `name`");
    }
    for (const char *section : {"body", "support", "traction", "probe"})
    {
      const Value *list = in.draft.root.find(section);
      std::map<std::string, int> first;
      for (std::size_t i = 0; list && i < list->items.size(); ++i)
      {
        const Value &item = list->items[i];
        const std::string name = label(item, section, i);
        const Value *key = item.find("name");
        const Value &at = key ? *key : item;
        if (const auto [seen, is_new] = first.emplace(name, item.place.line); !is_new)
          in.errors.add(
              at, "the name \"" + name + "\" is taken by line " + std::to_string(seen->second),
              "one name each", "add or change `name`");
        if (name.find('/') != std::string::npos || name == "." || name == "..")
          in.add_error(at, "the name \"" + name + "\" cannot stand in a record",
                       "names without a slash", "change `name`");
      }
    }
  }
} // namespace scene
