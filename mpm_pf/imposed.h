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

  /// Largest number of cells crossed per unit time along an axis, of what was written last.
  double crossing_rate() const { return rate; }

private:
  std::array<scene::Function, 2> component;
  bool steady;
  bool written = false;
  double rate = 0.;
};
