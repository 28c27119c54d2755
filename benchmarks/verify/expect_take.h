// The entries that expect.toml, tradeoff.toml and stability.toml share: constants, `take` and
// `against`.
#pragma once

#include "expect.h"
#include "section.h"

namespace verify
{
  /// Reads [constants], each an expression of those before it. Errors are noted in the section.
  void read_constants(Section &file, Constants &);
  /// `base`: where omitted keys come from (an `against` that names another run), or null.
  Take read_take(Section &, const Take *base);
  /// Reads the key `against` of a check whose take is known. Errors are noted in the section.
  Against read_against(Section &check_section, const Check &);
  /// Gives the check's `coverage`, if it has one, to its takes, which reduce lines by it.
  void hand_coverage_on(Check &);
  /// Notes at the key a norm that there is not, or that does not fit the take and what it is held
  /// against.
  void check_norm(Section &, const std::string &key, const Check &);
} // namespace verify
