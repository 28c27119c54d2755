// Which keys say something about which kind of take. One that says nothing would be ignored, and
// what was meant by it not measured.
#pragma once

#include "expect.h"
#include "section.h"

namespace verify
{
  /// What `written` keys of a take take the place of among those that it has from another one:
  /// another time, another reduction.
  void replace_inherited(Section &written, Take &);

  /// Notes every key of the section that says nothing about the take's kind, and what its kind
  /// needs and lacks.
  void check_keys(Section &, const Take &);

  /// Notes of a take, or of a table in the case folder, a reduction that there is not, `at` beside
  /// it (the whole history would be reduced) and a `between` that is no stretch.
  void check_reduction(Section &, const Take &);
} // namespace verify
