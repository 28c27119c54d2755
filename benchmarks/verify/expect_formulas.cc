#include "expect_formulas.h"

#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csv.h"

namespace verify
{
  namespace
  {
    using Names = std::set<std::string>;
    enum class Columns
    {
      none,
      any
    };

    void examine(Section &section, const std::string &key, const std::string &text,
                 const Constants &constants, const Names &also, Columns columns)
    {
      if (text.empty())
        return;
      try
      {
        for (const auto &name : unknown_names(text, constants))
          if (columns == Columns::none && also.count(name) == 0)
          {
            Names known = also;
            for (const auto &constant : constants)
              known.insert(constant.first);
            section.add_error(key, fmt::format("`{}`: no such name: `{}`", text, name),
                              known.empty() ? "there are no [constants]"
                                            : fmt::format("there are: {}", fmt::join(known, ", ")));
          }
      }
      catch (const BadInput &error)
      {
        section.add_error(key, error.what());
      }
    }

    /// Recordings are counted from 1.
    void check_nth(Section &section, const std::string &key, const Take &take,
                   const Constants &constants)
    {
      try
      {
        const double nth = take.nth.empty() ? 1. : evaluate(take.nth, constants);
        if (!(nth >= 1.) || nth != std::floor(nth))
          section.add_error(key, fmt::format("nth = {} is no recording", take.nth),
                            "give a whole number from 1");
      }
      catch (const BadInput &) // examine_take tells of it
      {
      }
    }

    void examine_take(Section &section, const std::string &key, const Take &take,
                      const Constants &constants)
    {
      using Kind = Take::Kind;
      const auto of_constants = [&](const std::string &text)
      { examine(section, key, text, constants, {}, Columns::none); };
      check_nth(section, key, take, constants);
      for (const auto &text :
           {take.at == "end" ? "" : take.at, take.nth, take.x, take.y, take.rotate})
        of_constants(text);
      for (const auto *list : {&take.between, &take.shift, &take.box})
        for (const auto &text : *list)
          of_constants(text);
      if (take.kind == Kind::table || take.kind == Kind::line || take.kind == Kind::snapshot)
        for (const auto &text : {take.of, take.abscissa})
          examine(section, key, text, constants, {}, Columns::any);
      if (take.kind != Kind::value || take.probes.empty())
        return;
      for (const auto &inner : take.with)
        examine_take(section, key, inner, constants);
      examine(section, key, take.probes[0][1], constants,
              Names(take.with_names.begin(), take.with_names.end()), Columns::none);
    }
  } // namespace

  void check_formulas(Section &section, const Check &check, const Constants &constants)
  {
    examine(section, "scale", check.scale, constants, {}, Columns::none);
    examine_take(section, "take", check.take, constants);
    if (check.against.kind == Against::Kind::run)
      examine_take(section, "against", check.against.take, constants);
    else if (check.against.kind == Against::Kind::formula)
      examine(section, "against", check.against.text, constants, {"x", "t"}, Columns::none);
    else if (check.against.kind == Against::Kind::number)
      examine(section, "against", check.against.text, constants, {}, Columns::none);
  }

  void check_csv(Section &section, const Check &check, const Case &c)
  {
    const std::string path = c.folder + "/" + check.against.text;
    if (check.against.kind != Against::Kind::csv || !std::filesystem::exists(path))
      return;
    try
    {
      const ColumnData columns = read_csv(path);
      for (const auto &text : {check.against.take.of, check.against.take.abscissa})
        for (const auto &name : unknown_names(text, c.constants))
          if (columns.count(name) == 0)
          {
            Names known;
            for (const auto &column : columns)
              known.insert(column.first);
            section.add_error("against", fmt::format("{} has no column `{}`", path, name),
                              fmt::format("there are: {}", fmt::join(known, ", ")));
          }
    }
    catch (const BadInput &error)
    {
      section.add_error("against", error.what());
    }
  }

  void read_limit(Section &section, Check &check, const Constants &constants)
  {
    const auto limits = section.expressions("limit");
    const bool interval = check.norm == "value" || !check.order_over.empty();
    if (limits.empty() || limits.size() > 2 || (interval && limits.size() == 1))
    {
      section.add_error("limit", interval
                                     ? "this check needs limit = [low, high]: limits are two-sided"
                                     : "this check needs limit = one number, or [low, high]");
      return;
    }
    check.low = limits.size() == 2 ? value_of(section, "limit", limits[0], constants) : 0.;
    check.high = value_of(section, "limit", limits.back(), constants);
    if (!(check.low <= check.high))
      section.add_error("limit", "the lower limit is above the upper one");
  }

  double value_of(Section &section, const std::string &key, const std::string &text,
                  const Constants &constants)
  {
    try
    {
      const double value = evaluate(text, constants);
      if (std::isfinite(value))
        return value;
      section.add_error(key, fmt::format("`{}` is {}", text, value), "a finite number is needed");
    }
    catch (const BadInput &error)
    {
      section.add_error(key, error.what());
    }
    return 0.;
  }
} // namespace verify
