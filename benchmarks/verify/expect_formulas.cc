#include "expect_formulas.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

    void examine_take(Section &section, const std::string &key, const Take &take,
                      const Constants &constants)
    {
      using Kind = Take::Kind;
      const auto of_constants = [&](const std::string &text)
      { examine(section, key, text, constants, {}, Columns::none); };
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

  void refuse_zero_scale(Section &section, const Check &check, const Constants &constants)
  {
    try
    {
      if (!check.scale.empty() && evaluate(check.scale, constants) == 0.)
        section.add_error("scale",
                          fmt::format("`{}` is zero: nothing can be divided by it", check.scale),
                          "leave `scale` out for a norm that nothing divides");
    }
    catch (const BadInput &) // check_formulas tells of it
    {
    }
  }

  double value_of(Section &section, const std::string &key, const std::string &text,
                  const Constants &constants)
  {
    try
    {
      return evaluate(text, constants);
    }
    catch (const BadInput &error)
    {
      section.add_error(key, error.what());
      return 0.;
    }
  }
} // namespace verify
