#include "formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include "quantity.h"
#include "scene/expression.h"
#include "scene/special_functions.h"
#include "section.h"

namespace verify
{
  namespace
  {
    [[noreturn]] void refuse(const std::string &text, const std::string &why)
    {
      throw BadInput(fmt::format("expression `{}`: {}", text, why));
    }

    /// muParser would take the last value of a list.
    double only_value(const mu::Parser &parser, const std::string &text)
    {
      int count = 0;
      const double *values = parser.Eval(count);
      if (count != 1)
        refuse(text, fmt::format("it is a list of {} values; the decimal sign is a point", count));
      return values[0];
    }

    mu::Parser parser_of(const std::string &text, const Constants &constants)
    {
      if (scene::assigns(text)) // muParser would let it
        refuse(text, "it assigns to a variable; == compares");
      mu::Parser parser;
      parser.DefineConst("pi", 3.14159265358979323846);
      parser.DefineFun("erf", scene::error_function);
      parser.DefineFun("erfc", scene::complementary_error_function);
      parser.DefineFun("E1", scene::exponential_integral);
      for (const auto &[name, value] : constants)
        parser.DefineConst(name, value);
      parser.SetExpr(text);
      return parser;
    }

    std::string names(const ColumnData &columns)
    {
      std::string all;
      for (const auto &[name, values] : columns)
        all += (all.empty() ? "" : ", ") + name;
      return all;
    }
  } // namespace

  double evaluate(const std::string &text, const Constants &constants)
  {
    try
    {
      return only_value(parser_of(text, constants), text);
    }
    catch (const mu::Parser::exception_type &error)
    {
      refuse(text, error.GetMsg());
    }
  }

  std::set<std::string> unknown_names(const std::string &text, const Constants &constants)
  {
    try
    {
      std::map<std::string, double> any; // evaluated for any values of the names: is it one value?
      mu::Parser asked = parser_of(text, constants); // owns what GetUsedVar refers to
      mu::Parser parser = parser_of(text, constants);
      for (const auto &used : asked.GetUsedVar())
        parser.DefineVar(used.first, &any.emplace(used.first, 1.).first->second);
      only_value(parser, text);
      std::set<std::string> names;
      for (const auto &[name, value] : any)
        names.insert(name);
      return names;
    }
    catch (const mu::Parser::exception_type &error)
    {
      refuse(text, error.GetMsg());
    }
  }

  std::vector<double> evaluate(const std::string &text, const Constants &constants,
                               const ColumnData &columns)
  {
    try
    {
      // A column hides a constant of the same name: what was measured is nearer than what was
      // declared.
      Constants visible;
      for (const auto &constant : constants)
        if (columns.count(constant.first) == 0)
          visible.push_back(constant);
      mu::Parser parser = parser_of(text, visible);
      std::map<std::string, double> row;
      std::size_t size = 0;
      for (const auto &[name, values] : columns)
      {
        if (name != "pi")
          parser.DefineVar(name, &row[name]);
        size = values.size();
      }
      std::vector<double> result(size);
      for (std::size_t i = 0; i < size; ++i)
      {
        for (const auto &[name, values] : columns)
          row[name] = values[i];
        result[i] = i == 0 ? only_value(parser, text) : parser.Eval();
      }
      if (size == 0)
        only_value(parser, text); // complains about unknown names even where there are no rows
      return result;
    }
    catch (const mu::Parser::exception_type &error)
    {
      if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
        throw MissingData(fmt::format("`{}`: no column `{}`; there are: {}", text, error.GetToken(),
                                      names(columns)));
      refuse(text, error.GetMsg());
    }
  }
} // namespace verify
