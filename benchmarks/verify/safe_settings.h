// What a stability map knows to be safe, near the settings of a run that failed.
#pragma once

#include <string>

#include "expect.h"

namespace verify
{
  /// One sentence per map of the case and axis that varies a setting of the run: the accurate (else
  /// bounded) cell nearest to it, the other axis staying where the run has it, to the nearest cell.
  /// The run's own values are those of its scene with the settings, or the defaults. The maps are
  /// those of <output>/stability/<case>.json, else of the folder of another suite beside it, where
  /// `verify stability` writes without --output. "" if no map knows better.
  std::string nearest_safe_setting(const std::string &output, const Case &, const Run &);
} // namespace verify
