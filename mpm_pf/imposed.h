// Motion imposed on the whole domain instead of a solid's: paper Secs. 2.3.1 and 2.3.2.
//
// The velocity is an expression of x, y, t at every node. A steady one is evaluated once; a uniform
// one costs one evaluation a step.
#pragma once

#include <array>

#include "medium/field.h"
#include "scene/expression.h"

class Imposed
{
public:
  /// Throws scene::BadScene if an expression does not compile.
  explicit Imposed(const scene::Imposed &);

  /// Velocity at `time` on all nodes and ghosts, length per time.
  void evaluate(double time, const medium::Mesh &, medium::Velocity &);

  /// Does what was evaluated last move anything?
  bool moves() const { return rate > 0.; }
  /// Does it not depend on time?
  bool steady() const { return is_steady; }
  /// May anything move at some time?
  bool may_move() const { return !is_steady || rate > 0.; }

  /// The longest step from `time` on, at most `longest`, in which the motion crosses no more than
  /// `fraction` of a cell along an axis, in a run that lasts until `end`. A function of its
  /// arguments alone, so that a run that was interrupted goes on with the same steps. While the
  /// motion changes it is resolved by 1/200 of the run at least, and the fastest of five moments of
  /// the step counts. Every fourth node is looked at. Throws medium::NumericalError if the run
  /// would stand still.
  struct StepLimits
  {
    double time, longest, end; // when it begins, its bound, end of the run
    double fraction;           // of a cell
  };
  double step(const StepLimits &, const medium::Mesh &) const;

private:
  template <class Visit>
  void for_sampled_nodes(const medium::Mesh &,
                         Visit &&) const; // visit(axis, x) at every fourth node
  double crossing_rate(double time, const medium::Mesh &) const;
  /// Is it the same all through a step of `length`, looked at every `spacing` of time?
  bool is_constant_over(double time, double length, double spacing, const medium::Mesh &) const;

  std::array<scene::Function, 2> component;
  bool is_steady;
  bool evaluated = false;
  double rate = 0.; // of what was evaluated last: cells crossed per unit time along an axis
};
