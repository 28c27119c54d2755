// Integration points as plain numbers, to be gathered from all processes or stored.
#pragma once

#include <vector>

#include "assembly.h"

namespace fe
{
  /// Ten numbers a point (stress 4, F 4, plastic strain, plastic work), whole on every process:
  /// each fills the cells that it owns.
  std::vector<double> gather_points(const Discretisation &, const std::vector<PointState> &);
  std::vector<PointState> unpack_points(const std::vector<double> &numbers);
} // namespace fe
