// Whether a history reaches the end of its run: a value "at the end" of a table that stops early
// would be one of another time, and two such values are no comparison.
#pragma once

#include <vector>

#include "record/reader.h"

namespace verify
{
  /// Throws MissingData if the times end more than their own widest spacing before the clock of the
  /// record's scene. Runs that may end before their clock (moving walls, a reason for the end in
  /// the record) and records without a scene are not held to it.
  void refuse_early_end(const record::Reader &, const std::vector<double> &times);
} // namespace verify
