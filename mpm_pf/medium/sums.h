// Sums over the nodes between the walls, by the area that each node owns. Rows are summed by
// themselves, by any thread, then one after the other: the same bits for any number of threads.
#pragma once

#include "medium/cuts.h"

namespace medium
{
  /// Integral over the active rectangle divided by the cell area. Compensated (Neumaier), so that
  /// it can witness conservation to 1e-15. A periodic node stored twice counts twice half.
  double weighted_sum(const Field<double> &, const Mesh &, const Cuts & = {});

  struct Statistics
  {
    double mean, variance, min, max;
  };
  /// What stands behind a wall is its mirror image and does not count.
  Statistics statistics_of(const Field<double> &, const Mesh &, const Cuts & = {});
} // namespace medium
