// Two takes "at the end" are of one time only if their runs end together.
#pragma once

#include <string>

#include "measure.h"

namespace verify
{
  /// Throws MissingData if what the check takes of `run` (its own, if empty) at the end and what it
  /// is held against at the end are more than 1e-3 of the run's length apart in time. Nothing is
  /// held to it that says its time, or that walls or a reason in the record have ended.
  void refuse_unequal_ends(const Check &, Records &, const std::string &run);
} // namespace verify
