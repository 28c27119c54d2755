#include "expect_take.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace verify
{
  namespace
  {
    const std::vector<std::string> reductions{"max",   "min",      "max_abs", "mean",
                                              "rms",   "first",    "last",    "range",
                                              "slope", "integral", "ripple"};
    const std::vector<std::string> of_outlines{"polygon", "area",      "perimeter", "side",
                                               "reach",   "extreme_x", "extreme_y"};
    const std::vector<std::string> sides{"left", "right", "bottom", "top"};
    const std::vector<std::pair<std::string, Take::Kind>> kinds{
        {"table", Take::Kind::table},     {"line", Take::Kind::line},
        {"outline", Take::Kind::outline}, {"snapshot", Take::Kind::snapshot},
        {"number", Take::Kind::number},   {"value", Take::Kind::value}};

    /// Finds which kind of probe the section names; keeps the base's if it names none.
    void read_kind(Section &section, Take &take, bool has_base)
    {
      int found = 0;
      for (const auto &[key, kind] : kinds)
        if (section.has(key))
        {
          ++found;
          take.kind = kind;
          take.probes.clear();
          if (kind == Take::Kind::table && section.is_section(key))
          {
            auto tables = *section.section(key);
            for (const auto &prefix : tables.keys())
              take.probes.push_back({prefix, tables.required_text(prefix)});
          }
          else
            take.probes.push_back({"", section.text(key)});
        }
      if (found > 1 || (found == 0 && !has_base))
        section.add_error("", "a take names one of table, line, outline, snapshot, number, value");
    }

    void read_with(Section &section, Take &take)
    {
      auto with = section.section("with");
      if (!with)
        return;
      take.with.clear();
      take.with_names.clear();
      for (const auto &name : with->keys())
        if (auto inner = with->section(name))
        {
          take.with_names.push_back(name);
          take.with.push_back(read_take(*inner, nullptr));
        }
    }

    bool any_of(const std::vector<std::string> &words, const std::string &word)
    {
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    void check_outline(Section &section, const Take &take)
    {
      if (take.of == "side" && (take.side.empty() || take.x.empty() == take.y.empty()))
        section.add_error("", "a side position needs side = \"left\" or \"right\" and y, or "
                              "side = \"top\" or \"bottom\" and x");
      if (take.of.rfind("extreme_", 0) == 0 && take.side.empty())
        section.add_error("", "an extreme needs side = \"left\", \"right\", \"bottom\" or \"top\"");
      if (!take.of.empty() && !any_of(of_outlines, take.of))
        section.add_error("of", fmt::format("an outline has no `{}`", take.of),
                          fmt::format("one of {}", fmt::join(of_outlines, ", ")));
      if (!take.side.empty() && !any_of(sides, take.side))
        section.add_error("side", fmt::format("no such side: `{}`", take.side),
                          fmt::format("one of {}", fmt::join(sides, ", ")));
    }

    void check_needs(Section &section, const Take &take)
    {
      using Kind = Take::Kind;
      if (take.kind == Kind::snapshot && take.reduce.empty())
        section.add_error("", "a snapshot needs `reduce`: max, min, mean, ...");
      for (const char *along : {"slope", "integral", "ripple"})
        if (take.kind == Kind::snapshot && take.reduce == along)
          section.add_error("reduce",
                            fmt::format("`{}` is along a line or over time; a snapshot has "
                                        "no abscissa",
                                        along));
      if (take.of.empty() &&
          (take.kind == Kind::table || take.kind == Kind::line || take.kind == Kind::snapshot))
        section.add_error("", "the take does not say which quantity: `of` is missing");
      if (take.kind == Kind::outline)
        check_outline(section, take);
      if (!take.mirror.empty() && take.mirror != "x" && take.mirror != "y" && take.mirror != "none")
        section.add_error("mirror", fmt::format("no such mirror: `{}`", take.mirror),
                          "\"x\" (x -> -x), \"y\" (y -> -y) or \"none\"");
      if (!take.mirror.empty() && take.kind != Kind::outline)
        section.add_error("mirror", "only an outline has a mirror image");
      if (!take.reduce.empty() && !any_of(reductions, take.reduce))
        section.add_error("reduce", fmt::format("no such reduction: `{}`", take.reduce));
      if (!take.between.empty() && take.between.size() != 2)
        section.add_error("between", "`between` is [from, to]");
      if (!take.box.empty() && take.box.size() != 4)
        section.add_error("box", "`box` is [[x0, y0], [x1, y1]]");
    }

    bool gives_outline(const Take &take)
    {
      return take.kind == Take::Kind::outline && (take.of.empty() || take.of == "polygon");
    }

    bool gives_curve(const Take &take)
    {
      return take.reduce.empty() &&
             (take.kind == Take::Kind::line || (take.kind == Take::Kind::table && take.at.empty()));
    }

    void check_norm(Section &section, const Check &check)
    {
      const bool of_outlines = check.norm == "hausdorff" || check.norm == "rms_distance" ||
                               check.norm.find("symmetric_difference") != std::string::npos;
      if (of_outlines != gives_outline(check.take))
        section.add_error("norm", of_outlines ? "this norm compares outlines"
                                              : "outlines need symmetric_difference, hausdorff or "
                                                "rms_distance");
      if (gives_curve(check.take) && (check.norm == "relative" || check.norm == "absolute"))
        section.add_error("norm", "this norm compares numbers and the take is a curve",
                          "take it with `at` or `reduce`, or say max, rms, l2 or mean");
      if ((check.norm == "value") != (check.against.kind == Against::Kind::nothing))
        section.add_error("norm", "`value` stands without `against`, every other norm with it");
    }

    Against read_against_table(Section &section, const Take &take)
    {
      Against against;
      if (const auto formula = section.expression("formula"))
      {
        against.kind = Against::Kind::formula;
        against.text = *formula;
      }
      else if (const auto number = section.expression("number"); number && !section.has("run"))
      {
        against.kind = Against::Kind::number;
        against.text = *number;
      }
      else if (section.has("csv"))
      {
        against.kind = Against::Kind::csv;
        against.text = section.text("csv");
        against.take.of = section.required_text("of");
        against.take.abscissa = section.text("abscissa", "time");
        against.take.at = section.expression("at").value_or("");
        against.take.between = section.expressions("between");
        against.take.reduce = section.text("reduce");
      }
      else
      {
        against.kind = Against::Kind::run;
        against.take = read_take(section, &take);
      }
      section.refuse_unused();
      return against;
    }
  } // namespace

  void read_constants(Section &file, Constants &constants)
  {
    auto section = file.section("constants");
    if (!section)
      return;
    for (const auto &key : section->keys())
      if (const auto text = section->expression(key))
        try
        {
          constants.emplace_back(key, evaluate(*text, constants));
        }
        catch (const BadInput &error)
        {
          section->add_error(key, error.what());
        }
  }

  Take read_take(Section &section, const Take *base)
  {
    Take take = base ? *base : Take();
    read_kind(section, take, base != nullptr);
    const bool makes_value = take.kind == Take::Kind::value;
    take.run = section.text("run", take.run);
    take.of = section.expression("of").value_or(take.of);
    take.abscissa = section.text("abscissa", take.abscissa);
    take.reduce = section.text("reduce", take.reduce);
    take.at = section.expression("at").value_or(take.at);
    take.nth = section.expression("nth").value_or(take.nth);
    take.side = section.text("side", take.side);
    take.x = section.expression("x").value_or(take.x);
    take.y = section.expression("y").value_or(take.y);
    if (section.has("between"))
    {
      take.between = section.expressions("between");
      take.along_abscissa = false;
    }
    if (section.has("between_abscissa"))
    {
      take.between = section.expressions("between_abscissa");
      take.along_abscissa = true;
    }
    take.mirror = section.text("mirror", take.mirror);
    take.rotate = section.expression("rotate").value_or(take.rotate);
    if (section.has("shift"))
      take.shift = section.expressions("shift");
    if (section.has("box"))
      take.box = section.expressions("box");
    if (makes_value)
      read_with(section, take);
    check_needs(section, take);
    section.refuse_unused();
    return take;
  }

  Against read_against(Section &section, const Check &check)
  {
    Against against;
    if (section.is_text("against"))
    {
      if (section.text("against") == "zero")
        against.kind = Against::Kind::zero;
      else
        section.add_error("against", "`against` is a table, or \"zero\"");
    }
    else if (auto table = section.section("against"))
      against = read_against_table(*table, check.take);
    Check known = check;
    known.against = against;
    check_norm(section, known);
    return against;
  }
} // namespace verify
