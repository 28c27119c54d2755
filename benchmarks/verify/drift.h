// This project's own last accepted values: <case>/accepted.toml, one table per suite, check name =
// value.
#pragma once

#include <string>
#include <vector>

#include "campaign.h"
#include "judge.h"

namespace verify
{
  /// Throws BadInput with every error of the accepted.toml of a case folder, if it has one.
  void check_accepted(const std::string &folder);

  /// Fills the drift of each verdict that has a value, from accepted.toml if there is one. Throws
  /// BadInput.
  void compare_with_accepted(std::vector<Verdict> &, const Case &);

  /// Writes the values of all verdicts that passed as the accepted ones of this suite. A check that
  /// did not pass keeps its old value (a machine without fe_reference accepts none of its own), one
  /// that is no longer among the verdicts loses it; other suites stay. Throws BadInput, or
  /// filesystem_error where the file cannot be written.
  void accept(const std::vector<Verdict> &, const Case &);

  /// The same for every case of a campaign. One whose file cannot be written keeps none of the
  /// others from it. Throws BadInput naming each of those.
  void accept(const Campaign &);
} // namespace verify
