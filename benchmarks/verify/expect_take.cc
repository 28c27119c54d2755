#include "expect_take.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expect_formulas.h"
#include "take_keys.h"

namespace verify
{
  namespace
  {
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

    bool gives_outline(const Take &take)
    {
      return take.kind == Take::Kind::outline && (take.of.empty() || take.of == "polygon");
    }

    bool gives_curve(const Take &take)
    {
      return take.reduce.empty() &&
             (take.kind == Take::Kind::line || (take.kind == Take::Kind::table && take.at.empty()));
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
        check_reduction(section, against.take);
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
        constants.emplace_back(key, value_of(*section, key, *text, constants));
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
    take.bin = section.expression("bin").value_or(take.bin);
    if (makes_value)
      read_with(section, take);
    if (base)
      replace_inherited(section, take);
    check_keys(section, take);
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
    return against;
  }

  void hand_coverage_on(Check &check)
  {
    for (Take *take : {&check.take, &check.against.take})
    {
      take->coverage = check.coverage.value_or(take->coverage);
      for (auto &inner : take->with)
        inner.coverage = take->coverage;
    }
  }

  void check_norm(Section &section, const std::string &key, const Check &check)
  {
    if (std::find(norms.begin(), norms.end(), check.norm) == norms.end())
    {
      section.add_error(key, fmt::format("no such norm: `{}`", check.norm),
                        fmt::format("one of {}", fmt::join(norms, ", ")));
      return;
    }
    const bool of_outlines = check.norm == "hausdorff" || check.norm == "rms_distance" ||
                             check.norm.find("symmetric_difference") != std::string::npos;
    if (of_outlines != gives_outline(check.take))
      section.add_error(key, of_outlines ? "this norm compares outlines"
                                         : "outlines need symmetric_difference, hausdorff or "
                                           "rms_distance");
    const bool of_rasters = check.take.kind == Take::Kind::snapshot && !check.take.bin.empty();
    if (of_rasters && check.norm.find("l2") != std::string::npos)
      section.add_error(key, "this norm integrates over a curve and the take is a raster",
                        "say max, rms or mean");
    if ((of_rasters || gives_curve(check.take)) &&
        (check.norm == "relative" || check.norm == "absolute"))
      section.add_error(key,
                        of_rasters ? "this norm compares numbers and the take is a raster"
                                   : "this norm compares numbers and the take is a curve",
                        of_rasters
                            ? "take it with `reduce` instead of `bin`, or say max, rms or mean"
                            : "take it with `at` or `reduce`, or say max, rms, l2 or mean");
    if ((check.norm == "value") != (check.against.kind == Against::Kind::nothing))
      section.add_error(key, "`value` stands without `against`, every other norm with it");
  }
} // namespace verify
