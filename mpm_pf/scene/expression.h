// Expressions of X, Y (initial position), x, y (current position) and t, compiled once with
// muParser.
//
// Beside muParser's own functions the scene language knows two smooth ramps, so that both solvers
// see the very same loading history: smooth(t, T) rises from 0 to 1 over T with two continuous
// derivatives (6s^5 - 15s^4 + 10s^3), and ramp(t, T) is its integral over time (a displacement
// whose speed rises smoothly from 0 to 1 over T and stays 1).
#pragma once

#include <memory>

#include <string>

#include "scene/domain.h"
#include "scene/reader.h"

namespace scene
{
  /// What an expression may be made of, for messages and the manual.
  inline constexpr const char *allowed_in_expressions =
      "numbers, X, Y (initial position), x, y (current position), t, pi, + - * / ^ ( ), sin, cos, "
      "exp, sqrt, abs, min, max, erf, erfc, E1 (exponential integral), a < b ? c : d, "
      "smooth(t, T), ramp(t, T)";

  /// The text is no expression; what() says all, `cause` only why.
  struct BadExpression : BadScene
  {
    std::string cause;
    BadExpression(const Expression &, const std::string &cause);
  };

  /// Does an expression write to a variable, which muParser would let it ("x = 3")?
  bool assigns(const std::string &expression);

  /// What an expression may depend on. Shapes: initial X and current x positions, length 2; time t.
  struct Argument
  {
    Point X = Point::Zero(), x = Point::Zero();
    double t = 0.;
  };

  /// A compiled expression. Copies share nothing, so each thread may own one.
  class Function
  {
  public:
    /// Throws BadExpression (file, line, what muParser says) if the text is not an expression of X,
    /// Y, x, y, t.
    explicit Function(const Expression &);
    Function(const Function &);
    Function(Function &&) noexcept;
    Function &operator=(Function);
    ~Function();

    double operator()(const Argument &) const;
    bool is_constant() const; // depends on nothing
    bool depends_on_time() const;
    bool depends_on_position() const;         // on any of X, Y, x, y
    bool depends_on_current_position() const; // on x or y

  private:
    struct Compiled;
    std::unique_ptr<Compiled> compiled;
  };

  /// d/dt of an expression at fixed positions, central difference of step h (fourth order).
  double time_derivative(const Function &, const Argument &, double h);
} // namespace scene
