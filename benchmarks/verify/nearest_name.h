// Did you mean: the known name nearest to what was written.
#pragma once

#include <set>
#include <string>

namespace verify
{
  /// The name with the fewest changed letters (at most three, fewer than it has); "" if none is
  /// near.
  std::string nearest_name(const std::string &written, const std::set<std::string> &known);
} // namespace verify
