#include "cannot_fail.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace verify
{
  namespace
  {
    using Kind = Take::Kind;

    /// With the defaults written out, so that they equal what says the same.
    Take spelt_out(Take take)
    {
      const bool at_one_time =
          take.kind == Kind::line || take.kind == Kind::outline || take.kind == Kind::snapshot;
      if (at_one_time && take.at.empty() && take.nth.empty())
        take.at = "end";
      if (take.abscissa.empty() && take.kind == Kind::table)
        take.abscissa = "time";
      if (take.abscissa.empty() && take.kind == Kind::line)
        take.abscissa = "s";
      if (take.of.empty() && take.kind == Kind::outline)
        take.of = "polygon";
      if (take.mirror == "none")
        take.mirror.clear();
      return take;
    }

    bool same(const Take &one, const Take &other)
    {
      const Take a = spelt_out(one), b = spelt_out(other);
      const auto words = [](const Take &t)
      {
        return std::tie(t.kind, t.run, t.probes, t.of, t.abscissa, t.reduce, t.at, t.nth, t.between,
                        t.along_abscissa, t.side, t.x, t.y, t.mirror, t.rotate, t.shift, t.box,
                        t.bin, t.with_names);
      };
      return words(a) == words(b) && a.with.size() == b.with.size() &&
             std::equal(a.with.begin(), a.with.end(), b.with.begin(), same);
    }

    /// Every name in an expression, constants too; nothing of one that is no expression, of which
    /// others tell.
    std::set<std::string> names_in(const std::string &text, const Constants &constants = {})
    {
      try
      {
        return text.empty() ? std::set<std::string>() : unknown_names(text, constants);
      }
      catch (const BadInput &)
      {
        return {"?"};
      }
    }

    void refuse_constant_takes(Section &section, const std::string &key, const Take &take,
                               const Constants &constants)
    {
      const bool of_columns =
          take.kind == Kind::table || take.kind == Kind::line || take.kind == Kind::snapshot;
      for (const auto &text : {take.of, take.abscissa})
        if (of_columns && !text.empty() && names_in(text, constants).empty())
          section.add_error(
              key, fmt::format("`{}` names no column: it is the same whatever the run does", text),
              "name a column of the probe; a constant that is called like one needs another name");
      if (take.kind != Kind::value || take.probes.empty())
        return;
      const auto used = names_in(take.probes[0][1]);
      if (used.empty())
        section.add_error(key,
                          fmt::format("`{}` is a number whatever the run does", take.probes[0][1]),
                          "name what is measured under `with`, or a constant that is checked");
      for (std::size_t i = 0; i < take.with.size(); ++i)
      {
        if (used.count(take.with_names[i]) == 0 && used.count("?") == 0)
          section.add_error(key,
                            fmt::format("`{}` does not use `{}` of `with`", take.probes[0][1],
                                        take.with_names[i]),
                            "use it, or leave it out");
        for (std::size_t k = 0; k < i; ++k)
          if (same(take.with[i], take.with[k]))
            section.add_error(key,
                              fmt::format("`{}` and `{}` of `with` are one and the same take",
                                          take.with_names[k], take.with_names[i]),
                              "take one of them from another run, probe or time");
        refuse_constant_takes(section, key, take.with[i], constants);
      }
    }

    void check_scale(Section &section, const Check &check, const Constants &constants)
    {
      try
      {
        const double scale = check.scale.empty() ? 1. : evaluate(check.scale, constants);
        if (!std::isfinite(scale) || scale == 0.)
          section.add_error(
              "scale",
              scale == 0.
                  ? fmt::format("`{}` is zero: nothing can be divided by it", check.scale)
                  : fmt::format("`{}` is {}: it says nothing about a size", check.scale, scale),
              "leave `scale` out for a norm that nothing divides");
      }
      catch (const BadInput &) // check_formulas tells of it
      {
      }
    }
  } // namespace

  void refuse_what_cannot_fail(Section &section, const Check &check, const Constants &constants)
  {
    if (check.order_over.empty() && check.against.kind == Against::Kind::run &&
        same(check.take, check.against.take))
      section.add_error("against", "the take is held against itself: the same run, probe and time",
                        "name another run, or another probe, time or quantity of this one");
    refuse_constant_takes(section, "take", check.take, constants);
    if (check.against.kind == Against::Kind::run)
      refuse_constant_takes(section, "against", check.against.take, constants);
    check_scale(section, check, constants);
    if (check.coverage && !(*check.coverage > 0. && *check.coverage <= 1.))
      section.add_error("coverage", fmt::format("a coverage of {} is none", *check.coverage),
                        "a part of the samples: above 0, at most 1");
  }

  void refuse_equal_grids(Section &section, const std::string &key,
                          const std::vector<const Run *> &runs)
  {
    std::map<double, std::string> known;
    for (const Run *run : runs)
      if (run && run->h)
        if (const auto [first, fresh] = known.emplace(*run->h, run->name); !fresh)
          section.add_error(key,
                            first->second == run->name
                                ? fmt::format("run `{}` is named twice", run->name)
                                : fmt::format("runs `{}` and `{}` both have h = {}", first->second,
                                              run->name, *run->h),
                            "name runs that differ in their mesh size");
  }

  void check_mesh_size(Section &section, const Run &run)
  {
    if (run.h && !(*run.h > 0. && std::isfinite(*run.h)))
      section.add_error("h", fmt::format("a mesh size of {} is none", *run.h),
                        "give a length above zero");
  }
} // namespace verify
