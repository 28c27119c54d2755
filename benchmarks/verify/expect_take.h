// The `take` and `against` entries of a check.
#pragma once

#include "expect.h"
#include "section.h"

namespace verify
{
  /// `base`: where omitted keys come from (an `against` that names another run), or null.
  Take read_take(Section &, const Take *base);
  /// Reads the key `against` of a check whose take and norm are known. Errors are noted in the section.
  Against read_against(Section &check_section, const Check &);
} // namespace verify
