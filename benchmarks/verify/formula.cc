#include "formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include "quantity.h"
#include "scene/special_functions.h"
#include "section.h"

namespace verify
{
  namespace
  {
    mu::Parser parser_of(const std::string &text, const Constants &constants)
    {
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
      return parser_of(text, constants).Eval();
    }
    catch (const mu::Parser::exception_type &error)
    {
      throw BadInput(fmt::format("expression `{}`: {}", text, error.GetMsg()));
    }
  }

  std::set<std::string> unknown_names(const std::string &text, const Constants &constants)
  {
    try
    {
      std::set<std::string> names;
      mu::Parser parser = parser_of(text, constants); // owns what GetUsedVar refers to
      for (const auto &used : parser.GetUsedVar())
        names.insert(used.first);
      return names;
    }
    catch (const mu::Parser::exception_type &error)
    {
      throw BadInput(fmt::format("expression `{}`: {}", text, error.GetMsg()));
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
        result[i] = parser.Eval();
      }
      if (size == 0)
        parser.Eval(); // complains about unknown names even where there are no rows
      return result;
    }
    catch (const mu::Parser::exception_type &error)
    {
      if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
        throw MissingData(fmt::format("`{}`: no column `{}`; there are: {}", text, error.GetToken(),
                                      names(columns)));
      throw BadInput(fmt::format("expression `{}`: {}", text, error.GetMsg()));
    }
  }
} // namespace verify
