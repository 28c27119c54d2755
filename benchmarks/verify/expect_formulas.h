// Formulas of expect.toml and the like, checked as they are read: a mistake is reported with its
// place before anything runs, not after the runs that it was to judge.
#pragma once

#include <string>

#include "expect.h"
#include "section.h"

namespace verify
{
  /// Notes in the section every formula of the check that is no expression, and every name in one
  /// of constants that is none. Names of columns are known only when the record is.
  void check_formulas(Section &, const Check &, const Constants &);

  /// Notes a `scale` that is zero: a norm would be divided by it.
  void refuse_zero_scale(Section &, const Check &, const Constants &);

  /// The value of an expression of constants; one that has none is noted at the key, and is 0.
  double value_of(Section &, const std::string &key, const std::string &text, const Constants &);
} // namespace verify
