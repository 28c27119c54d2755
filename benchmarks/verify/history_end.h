// Whether a history reaches the end of its run. Of one that stops early the value at the end would
// be that of another time, a maximum perhaps not the largest, and against a formula, which knows no
// end of its own, nothing would be missing.
#pragma once

#include <string>
#include <vector>

#include "record/reader.h"

namespace verify
{
  /// Throws MissingData if the times of a table end more than their own widest spacing before the
  /// clock of the record's scene, or before the last of the times that the scene lists for this
  /// probe. Runs that may end before their clock (moving walls, a reason for the end in the record)
  /// and records without a scene are not held to it.
  void refuse_early_end(const record::Reader &, const std::string &table,
                        const std::vector<double> &times);
} // namespace verify
