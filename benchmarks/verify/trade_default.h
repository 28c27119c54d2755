// The trade of a case that declares none: its own checks are the quantities, and the knobs are
// those that every scene of its kind has.
#pragma once

#include "trade_file.h"

namespace verify
{
  /// Measures: the checks of expect.toml that hold one run of the case's scene against theory, a
  /// table or finite elements. Families: cells, points, step, precision, scheme, presets; elements
  /// where the case runs them. Throws BadInput if none of the checks can be measured like that.
  Trade default_trade(const std::string &folder);
} // namespace verify
