// Integration points as plain numbers, to be gathered from all processes or stored.
#pragma once

#include <vector>

#include "assembly.h"

namespace fe
{
  /// Ten numbers a point (stress 4, F 4, plastic strain, plastic work), whole on every process:
  /// each fills the cells that it owns.
  std::vector<double> whole_points(const Discretisation &, const std::vector<PointState> &);
  std::vector<PointState> points_from(const std::vector<double> &numbers);
} // namespace fe
