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

  /// Notes what is wrong with the table in the case folder that the check is held against, and
  /// columns that it does not have. One that is not there is a missing reference, of which the
  /// verdict tells.
  void check_csv(Section &, const Check &, const Case &);

  /// Reads the key `limit` of a check whose norm is known: one number, or [low, high].
  void read_limit(Section &, Check &, const Constants &);

  /// The value of an expression of constants; one that has none, or no finite one, is noted at the
  /// key, and is 0.
  double value_of(Section &, const std::string &key, const std::string &text, const Constants &);
} // namespace verify
