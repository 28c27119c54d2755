// Motion imposed on the whole domain instead of a solid's: paper Secs. 2.3.1 and 2.3.2.
//
// The velocity is an expression of x, y, t at every node. A steady one is written once; a uniform
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
  void write(double time, const medium::Mesh &, medium::Velocity &);

  /// Does what was written last move anything?
  bool moves() const { return rate > 0.; }
  /// Does it not depend on time?
  bool steady() const { return is_steady; }
  /// May anything move at some time?
  bool ever_moves() const { return !is_steady || rate > 0.; }

  /// The longest step from `time` on, at most `longest`, in which the motion crosses no more than
  /// `fraction` of a cell along an axis, in a run that lasts until `end`. A function of its
  /// arguments alone, so that a run that was interrupted goes on with the same steps. Of an
  /// unsteady motion the fastest moment of the step counts (five are looked at, on every fourth
  /// node). Throws medium::NumericalTrouble if the run would stand still.
  double step(double time, double longest, double end, double fraction, const medium::Mesh &) const;

private:
  double crossing_rate(double time, const medium::Mesh &) const;

  std::array<scene::Function, 2> component;
  bool is_steady;
  bool written = false;
  double rate = 0.; // of what was written last: cells crossed per unit time along an axis
};
