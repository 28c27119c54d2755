#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/geometry.h"
#include "scene/quantities.h"
#include "scene/rules_list.h"
#include "scene/schedule.h"

namespace scene
{
  namespace
  {
    // A record of more is a slip of the unit: a run has at most as many steps.
    constexpr double most_records = 1e7;

    bool in_domain(const Point &p, const Domain &domain)
    {
      const double slack = 1e-6 * domain.spacing().minCoeff();
      return (p.array() >= domain.lower.array() - slack).all() &&
             (p.array() <= domain.upper().array() + slack).all();
    }

    std::string pair(const Point &p)
    {
      return "(" + number_text(p[0]) + ", " + number_text(p[1]) + ")";
    }

    void check_point(const Point &p, const Value &at, const Inspection &in)
    {
      const Domain &domain = in.scene().domain;
      if (!in_domain(p, domain))
        in.add_error(at, "the probe looks at " + pair(p) + ", outside the domain",
                     "positions from " + pair(domain.lower) + " to " + pair(domain.upper()),
                     "move the probe, or enlarge the domain");
    }

    void check_region(const RegionProbe &region, const Value &at, const Inspection &in)
    {
      const Domain &domain = in.scene().domain;
      if (region.box && ((region.box->lower.array() >= domain.upper().array()).any() ||
                         (region.box->upper.array() <= domain.lower.array()).any()))
        in.add_error(at, "the probe's region lies outside the domain",
                     "regions that overlap the domain", "move the region");
      else if (region.box && in.geometry_known && !in.present("growth") &&
               !holds_material(*region.box, in.scene().bodies))
        in.add_error(at, "no material starts in the probe's region", "a box that overlaps a body",
                     "move the region");
    }

    template <class Names>
    std::vector<std::string> texts(const Names &names)
    {
      return {names.begin(), names.end()};
    }

    // Which section must be there for a quantity to exist.
    std::vector<std::string> modules_of(const std::string &quantity)
    {
      if (quantity == "phi")
        return {"phase_field"};
      if (quantity == "theta")
        return {"heat"};
      if (quantity == "crystal_angle")
        return {"orientation"};
      if (quantity == "velocity_x" || quantity == "velocity_y")
        return {"solid", "imposed"};
      return {"solid"};
    }

    // A volume mean is taken over material points or finite elements, which know no melt.
    void check_of_region(const std::string &quantity, const Value &at, const Inspection &in)
    {
      if (is_melt_quantity(quantity))
        in.errors.add(at, "a region's mean of \"" + quantity + "\": regions are of the solid",
                      "quantities of the solid: " + comma_separated(texts(solid_quantities)),
                      "a line or point probe, or history = true for means over the domain");
    }

    const Value &item_or_whole(const Value &list, const std::size_t index)
    {
      return index < list.items.size() ? list.items[index] : list;
    }
  } // namespace

  void probes_lie_inside(const Inspection &in)
  {
    if (!in.present("domain") || in.errors.about(in.at("domain")))
      return;
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
    {
      const Probe &probe = in.scene().probes[i];
      const Value &at = *in.draft.probes[i];
      if (const auto *line = std::get_if<LineProbe>(&probe.kind))
      {
        check_point(line->a, *at.find("line"), in);
        check_point(line->b, *at.find("line"), in);
        if (line->a == line->b)
          in.add_error(*at.find("line"), "the line has no length", "two different points",
                       "write at = [x, y] for a point");
      }
      else if (const auto *point = std::get_if<PointProbe>(&probe.kind))
      {
        check_point(point->at, *at.find("at"), in);
        const double slack = 1e-6 * in.scene().domain.spacing().minCoeff();
        if (in.geometry_known && point->frame == Frame::material &&
            signed_distance(in.scene().bodies, point->at) < -slack)
          in.add_error(*at.find("at"),
                       "no material starts at " + pair(point->at) + ", and frame is \"material\"",
                       "a point of a body, or frame = \"current\"", "move the point");
      }
      else if (const auto *region = std::get_if<RegionProbe>(&probe.kind))
        check_region(*region, *at.find("region"), in);
      else if (const auto *tip = std::get_if<TipProbe>(&probe.kind))
        check_point(tip->origin, *at.find("tip"), in);
    }
  }

  void quantities_are_known(const Inspection &in)
  {
    std::vector<std::string> known = texts(solid_quantities);
    for (const auto &name : melt_quantities)
      known.emplace_back(name);
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
    {
      const Value *list = in.draft.probes[i]->find("of");
      const std::vector<std::string> &of = in.scene().probes[i].of;
      for (std::size_t k = 0; list && k < of.size(); ++k)
      {
        const std::vector<std::string> modules = modules_of(of[k]);
        if (std::find(known.begin(), known.end(), of[k]) == known.end())
          in.errors.add(item_or_whole(*list, k), "there is no quantity \"" + of[k] + "\"",
                        comma_separated(known), did_you_mean(of[k], known));
        else if (std::none_of(modules.begin(), modules.end(),
                              [&](const std::string &m) { return in.present(m); }))
          in.errors.add(item_or_whole(*list, k),
                        "the quantity \"" + of[k] + "\" needs [" + modules.front() + "]",
                        "quantities of the modules that are on",
                        "add [" + modules.front() + "], or leave the quantity out");
        else if (in.present("growth") && needs_initial_position(of[k]))
          in.errors.add(item_or_whole(*list, k),
                        "\"" + of[k] +
                            "\" of a growing crystal: what grew has no place in "
                            "the first configuration to be strained from",
                        "plastic_strain, jacobian, or the stresses", "leave it out");
        else if (std::holds_alternative<RegionProbe>(in.scene().probes[i].kind))
          check_of_region(of[k], item_or_whole(*list, k), in);
      }
    }
  }

  void reactions_have_a_support(const Inspection &in)
  {
    std::vector<std::string> names;
    const auto collect = [&](const char *section, const std::string &prefix)
    {
      if (const Value *list = in.draft.root.find(section))
        for (std::size_t i = 0; i < list->items.size(); ++i)
          names.push_back(prefix + label(list->items[i], section, i));
    };
    collect("support", "");
    collect("wall", "wall ");
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
      if (const auto *reaction = std::get_if<ReactionProbe>(&in.scene().probes[i].kind))
        if (std::find(names.begin(), names.end(), reaction->support) == names.end())
          in.add_error(*in.draft.probes[i]->find("reaction"),
                       "there is no support \"" + reaction->support + "\"",
                       names.empty() ? "the name of a support; this scene has none"
                                     : comma_separated(names),
                       did_you_mean(reaction->support, names));
  }

  void followed_things_exist(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
    {
      const Probe &probe = in.scene().probes[i];
      const Value &at = *in.draft.probes[i];
      if (std::holds_alternative<TipProbe>(probe.kind) && !in.present("phase_field"))
        in.add_error(*at.find("tip"), "a dendrite tip without [phase_field]", "",
                     "add [phase_field], or remove the probe");
      if (std::holds_alternative<RegionProbe>(probe.kind) && !in.present("solid"))
        in.add_error(*at.find("region"), "a mean over material without [solid]", "",
                     "history = true gives means over the domain; or add [solid]");
      if (const auto *outline = std::get_if<OutlineProbe>(&probe.kind))
      {
        const std::string needed = outline->of == OutlineProbe::Of::phase ? "phase_field" : "solid";
        if (!in.present(needed))
          in.add_error(*at.find("outline"), "this outline needs [" + needed + "]",
                       "\"material\" with [solid], \"phase\" with [phase_field]",
                       "add [" + needed + "], or ask for the other outline");
      }
    }
  }

  void times_lie_in_the_run(const Inspection &in)
  {
    const bool clock = in.present("clock") && !in.errors.about(in.at("clock"));
    const double end = in.scene().clock.end * (1. + rounding_of_times);
    for (std::size_t i = 0; i < in.scene().probes.size(); ++i)
    {
      const Probe &probe = in.scene().probes[i];
      const Value &at = *in.draft.probes[i];
      const std::string allowed =
          "increasing times up to the end, " + number_text(in.scene().clock.end);
      for (const char *key : {"times", "compressions"})
        if (const Value *value = at.find(key))
        {
          const auto &list = std::string(key) == "times" ? probe.times : probe.compressions;
          if (list.empty())
            in.add_error(*value, "an empty list", allowed, "remove the key");
          else if (std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) !=
                   list.end())
            in.add_error(*value, "the list does not increase", allowed, "sort it");
        }
      if (clock && !probe.times.empty() && probe.times.back() > end)
        in.add_error(*at.find("times"),
                     "the time " + number_text(probe.times.back()) + " is past the end", allowed,
                     "remove the time, or run longer");
      if (clock && probe.every && *probe.every > end)
        in.add_error(*at.find("every"),
                     "an interval of " + number_text(*probe.every) + " is longer than the run",
                     "at most the end, " + number_text(in.scene().clock.end),
                     "shorten it, or run longer");
      if (clock && probe.every && end / *probe.every > most_records)
        in.add_error(*at.find("every"),
                     "an interval of " + number_text(*probe.every) + " makes " +
                         number_text(std::floor(end / *probe.every)) + " records",
                     "at most " + number_text(most_records) + " records", "a longer interval");
      if (!probe.compressions.empty() && !in.present("wall"))
        in.add_error(*at.find("compressions"), "compressions without a wall", "",
                     "add [[wall]], or give times");
    }
  }
} // namespace scene
