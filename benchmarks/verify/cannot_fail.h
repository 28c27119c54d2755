// Checks that cannot fail, or not for the reason they give: refused as they are read, for a verdict
// that is certain beforehand says nothing.
#pragma once

#include <string>
#include <vector>

#include "expect.h"
#include "section.h"

namespace verify
{
  /// Notes a check that holds a take against itself, takes constants only, has takes in `with` that
  /// nothing uses or that are one and the same, a `scale` that is zero or not finite, and a
  /// `coverage` that is none.
  void refuse_what_cannot_fail(Section &, const Check &, const Constants &);

  /// Notes grids of one mesh size: their differences say nothing about what is left on the finest.
  /// `h`: name and mesh size of each run; runs without a size are passed over.
  void refuse_equal_grids(Section &, const std::string &key, const std::vector<const Run *> &);

  /// Notes a mesh size at the key `h` that is not above zero.
  void check_mesh_size(Section &, const Run &);
} // namespace verify
