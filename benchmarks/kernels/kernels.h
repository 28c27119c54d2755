// Micro-benchmarks, each registered with what one iteration handles and the goal it has to meet.
//
// Absolute times move from machine to machine; what is gated is the ratio to a triad pass,
// a = b + s c over 1200 x 800 doubles, measured in the same run, interleaved, the best of several
// repetitions. All kernels run on one thread.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "medium/field.h"

namespace kernels
{
  struct Goal
  {
    double items;   // nodes, points or band cells that one iteration handles
    double triads;  // allowed per item, in triads per node
    double stretch; // wished for
  };

  /// Registers `iteration` under `name`. `set_up` makes the state once, at the first use.
  void add(const std::string &name, const Goal &,
           const std::function<std::function<void()>()> &set_up);

  void add_growth_kernels();
  void add_advection_kernels();
  void add_solid_kernels();

  /// A mesh of nx x ny nodes, dx = 0.4, symmetry on all sides.
  medium::Mesh mesh_of(int nx, int ny);
} // namespace kernels
