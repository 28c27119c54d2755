#include "scene/expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <muParser.h>

#include "scene/reader.h"
#include "scene/special_functions.h"

namespace scene
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    // Rises from 0 to 1 over T with two continuous derivatives.
    double smooth(const double t, const double T)
    {
      if (T < 0.)
        return std::numeric_limits<double>::quiet_NaN();
      if (t >= T)
        return t > 0. ? 1. : 0.;
      const double s = t <= 0. ? 0. : t / T;
      return s * s * s * (10. + s * (-15. + 6. * s));
    }

    // The integral of smooth() over time: s^6 - 3 s^5 + 5/2 s^4, times T; then a straight line.
    double ramp(const double t, const double T)
    {
      if (T < 0.)
        return std::numeric_limits<double>::quiet_NaN();
      if (t <= 0. || T == 0.)
        return std::max(t, 0.);
      const double s = t / T;
      return s >= 1. ? t - 0.5 * T : T * s * s * s * s * (2.5 + s * (-3. + s));
    }

    [[noreturn]] void refuse(const Expression &expression, const std::string &cause)
    {
      throw BadExpression(expression, cause);
    }
  } // namespace

  bool assigns(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '=')
      {
        const bool pair = i + 1 < text.size() && text[i + 1] == '=';
        const bool after_comparison =
            i > 0 && (text[i - 1] == '<' || text[i - 1] == '>' || text[i - 1] == '!');
        if (!pair && !after_comparison)
          return true;
        i += pair ? 1 : 0;
      }
    return false;
  }

  BadExpression::BadExpression(const Expression &expression, const std::string &why)
      : BadScene(expression.place.file + ":" + std::to_string(expression.place.line) + ": " +
                 expression.place.key + ": \"" + expression.text + "\" is no expression: " + why +
                 "\n  allowed: " + allowed_in_expressions),
        cause("\"" + expression.text + "\" is no expression: " + why)
  {
  }

  struct Function::Compiled
  {
    Expression expression;
    mu::Parser parser;
    Argument argument; // muParser reads the variables from here
    bool constant = true, timed = false, placed = false, current = false;
    double value = 0.; // of a constant

    explicit Compiled(const Expression &e) : expression(e)
    {
      if (assigns(e.text))
        refuse(e, "it assigns to a variable");
      try
      {
        define_names();
        parser.SetExpr(e.text);
        // Evaluated first: after GetUsedVar muParser would read an unknown name as a variable.
        int results = 0;
        const double first = parser.Eval(results)[0];
        if (results != 1)
          refuse(e, "it is a list of " + std::to_string(results) + " values");
        const auto used = parser.GetUsedVar();
        constant = used.empty();
        timed = used.count("t") > 0;
        placed = used.size() > (timed ? 1u : 0u);
        current = used.count("x") > 0 || used.count("y") > 0;
        value = constant ? first : 0.;
      }
      catch (const mu::ParserError &error)
      {
        refuse(e, error.GetMsg());
      }
      if (constant && !std::isfinite(value))
        refuse(e, "its value is not finite");
    }

    void define_names()
    {
      parser.DefineConst("pi", pi);
      parser.DefineVar("X", &argument.X[0]);
      parser.DefineVar("Y", &argument.X[1]);
      parser.DefineVar("x", &argument.x[0]);
      parser.DefineVar("y", &argument.x[1]);
      parser.DefineVar("t", &argument.t);
      parser.DefineFun("smooth", smooth);
      parser.DefineFun("ramp", ramp);
      parser.DefineFun("erf", error_function);
      parser.DefineFun("erfc", complementary_error_function);
      parser.DefineFun("E1", exponential_integral);
    }
  };

  Function::Function(const Expression &expression)
      : compiled(std::make_unique<Compiled>(expression))
  {
  }

  // The parser keeps pointers to its variables: a copy compiles the text anew, with its own.
  Function::Function(const Function &other)
      : compiled(std::make_unique<Compiled>(other.compiled->expression))
  {
  }

  Function::Function(Function &&) noexcept = default;

  Function &Function::operator=(Function other)
  {
    std::swap(compiled, other.compiled);
    return *this;
  }

  Function::~Function() = default;

  double Function::operator()(const Argument &argument) const
  {
    if (compiled->constant)
      return compiled->value;
    compiled->argument = argument;
    return compiled->parser.Eval();
  }

  bool Function::is_constant() const
  {
    return compiled->constant;
  }

  bool Function::depends_on_time() const
  {
    return compiled->timed;
  }

  bool Function::depends_on_position() const
  {
    return compiled->placed;
  }

  bool Function::depends_on_current_position() const
  {
    return compiled->current;
  }

  double time_derivative(const Function &f, const Argument &argument, const double h)
  {
    if (!f.depends_on_time())
      return 0.;
    const auto at = [&](const double shift)
    {
      Argument shifted = argument;
      shifted.t += shift;
      return f(shifted);
    };
    return (8. * (at(h) - at(-h)) - (at(2. * h) - at(-2. * h))) / (12. * h);
  }
} // namespace scene
