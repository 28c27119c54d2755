#include "take_keys.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace verify
{
  namespace
  {
    using Kind = Take::Kind;
    using Words = std::vector<std::string>;

    const Words reductions{"max",  "min",   "max_abs", "mean",     "rms",   "first",
                           "last", "range", "slope",   "integral", "ripple"};
    const Words of_outlines{"polygon", "area",      "perimeter", "side",
                            "reach",   "extreme_x", "extreme_y"};
    const Words sides{"left", "right", "bottom", "top"};

    const std::vector<std::pair<std::string, std::vector<Kind>>> kinds_with{
        {"of", {Kind::table, Kind::line, Kind::outline, Kind::snapshot}},
        {"abscissa", {Kind::table, Kind::line}},
        {"at", {Kind::table, Kind::line, Kind::outline, Kind::snapshot}},
        {"nth", {Kind::line, Kind::outline, Kind::snapshot}},
        {"between", {Kind::table, Kind::line}},
        {"between_abscissa", {Kind::table}},
        {"reduce", {Kind::table, Kind::line, Kind::snapshot}},
        {"side", {Kind::outline}},
        {"x", {Kind::outline}},
        {"y", {Kind::outline}},
        {"mirror", {Kind::outline, Kind::snapshot}},
        {"rotate", {Kind::outline}},
        {"shift", {Kind::outline}},
        {"box", {Kind::snapshot}},
        {"bin", {Kind::snapshot}},
        {"with", {Kind::value}}};

    std::string with_article(const Kind kind)
    {
      static const char *const names[] = {"a table",    "a line",   "an outline",
                                          "a snapshot", "a number", "a value"};
      return names[static_cast<int>(kind)];
    }

    bool any_of(const Words &words, const std::string &word)
    {
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    void refuse_foreign_keys(Section &section, const Take &take)
    {
      for (const auto &[key, kinds] : kinds_with)
        if (section.has(key) && std::find(kinds.begin(), kinds.end(), take.kind) == kinds.end())
        {
          Words names;
          for (const Kind kind : kinds)
            names.push_back(with_article(kind));
          section.add_error(key,
                            fmt::format("`{}` says nothing about {}", key, with_article(take.kind)),
                            fmt::format("only {} has it: leave it out", fmt::join(names, ", ")));
        }
    }

    bool is_extreme(const Take &take)
    {
      return take.of == "extreme_x" || take.of == "extreme_y";
    }

    void check_mirror(Section &section, const Take &take)
    {
      if (!take.mirror.empty() && take.mirror != "x" && take.mirror != "y" && take.mirror != "none")
        section.add_error("mirror", fmt::format("no such mirror: `{}`", take.mirror),
                          "\"x\" (x -> -x), \"y\" (y -> -y) or \"none\"");
    }

    void check_outline(Section &section, const Take &take)
    {
      const bool level = take.side == "left" || take.side == "right";
      if (take.of == "side" && (take.side.empty() || take.x.empty() == take.y.empty() ||
                                (any_of(sides, take.side) && level == take.y.empty())))
        section.add_error("", "a side position needs side = \"left\" or \"right\" and y, or "
                              "side = \"top\" or \"bottom\" and x");
      if (is_extreme(take) && take.side.empty())
        section.add_error("", "an extreme needs side = \"left\", \"right\", \"bottom\" or \"top\"");
      if (!take.of.empty() && !any_of(of_outlines, take.of))
        section.add_error("of", fmt::format("an outline has no `{}`", take.of),
                          fmt::format("one of {}", fmt::join(of_outlines, ", ")));
      if (!take.side.empty() && !any_of(sides, take.side))
        section.add_error("side", fmt::format("no such side: `{}`", take.side),
                          fmt::format("one of {}", fmt::join(sides, ", ")));
      const std::string of = take.of.empty() ? "polygon" : take.of;
      if (section.has("side") && of != "side" && !is_extreme(take))
        section.add_error("side", fmt::format("`side` says nothing about of = \"{}\"", of),
                          "only of = \"side\", \"extreme_x\" and \"extreme_y\" have one");
      for (const char *key : {"x", "y"})
        if (section.has(key) && of != "side")
          section.add_error(key, fmt::format("`{}` says nothing about of = \"{}\"", key, of),
                            "only of = \"side\" is asked for at an x or a y");
      if (section.has("shift") && take.shift.size() != 2)
        section.add_error("shift", "`shift` is [x, y]", "give both numbers");
    }

    void check_snapshot(Section &section, const Take &take)
    {
      if (take.reduce.empty() == take.bin.empty())
        section.add_error("", "a snapshot needs `reduce` (max, min, mean, ...: a number) or `bin` "
                              "(the side of squares: a field), and not both");
      if (section.has("mirror") && take.bin.empty())
        section.add_error("mirror", "`mirror` says nothing about a number",
                          "only a snapshot with `bin` and an outline have one");
      for (const char *along : {"slope", "integral", "ripple"})
        if (take.reduce == along)
          section.add_error("reduce",
                            fmt::format("`{}` is along a line or over time; a snapshot has "
                                        "no abscissa",
                                        along));
      if (section.has("box") && take.box.size() != 4)
        section.add_error("box", "`box` is [[x0, y0], [x1, y1]]");
    }
  } // namespace

  void replace_inherited(Section &written, Take &take)
  {
    const bool at = written.has("at"), nth = written.has("nth"), reduce = written.has("reduce");
    if (take.kind == Kind::table && at && !reduce)
      take.reduce.clear();
    if (take.kind == Kind::table && reduce && !at)
      take.at.clear();
    if (nth && !at)
      take.at.clear();
    if (at && !nth)
      take.nth.clear();
  }

  void check_keys(Section &section, const Take &take)
  {
    refuse_foreign_keys(section, take);
    if (take.of.empty() &&
        (take.kind == Kind::table || take.kind == Kind::line || take.kind == Kind::snapshot))
      section.add_error("", "the take does not say which quantity: `of` is missing");
    check_mirror(section, take);
    if (take.kind == Kind::outline)
      check_outline(section, take);
    if (take.kind == Kind::snapshot)
      check_snapshot(section, take);
    if (section.has("nth") && section.has("at") && take.kind != Kind::table)
      section.add_error("nth", "`nth` and `at` both say which recording is meant",
                        "leave one of them out");
    check_reduction(section, take);
  }

  void check_reduction(Section &section, const Take &take)
  {
    if (!take.reduce.empty() && !any_of(reductions, take.reduce))
      section.add_error("reduce", fmt::format("no such reduction: `{}`", take.reduce),
                        fmt::format("one of {}", fmt::join(reductions, ", ")));
    if (take.kind == Kind::table && !take.at.empty() && !take.reduce.empty())
      section.add_error("at", "`at` beside `reduce`: the whole history would be reduced",
                        "leave `at` out, or say `between` for the stretch that is reduced");
    if (!take.between.empty() && take.between.size() != 2)
      section.add_error(
          take.along_abscissa ? "between_abscissa" : "between",
          fmt::format("`{}` is [from, to]", take.along_abscissa ? "between_abscissa" : "between"));
  }
} // namespace verify
