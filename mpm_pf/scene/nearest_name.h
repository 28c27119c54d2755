// Did you mean: the known name nearest to what was written, for the errors of scenes and campaigns.
#pragma once

#include <string>
#include <vector>

namespace scene
{
  /// The name with the smallest edit distance, with swaps of neighbouring letters, of at most a
  /// third of the length and one; the first of several; "" if none is near.
  std::string nearest_name(const std::string &written, const std::vector<std::string> &known);
} // namespace scene
