// What a run may ask for: values beyond it are refused with the file, before any work.
#pragma once

#include <string>

#include "section.h"

namespace verify
{
  /// `threads` or `processes`: a whole number from 1 to 1024; 1 if the key is absent or wrong.
  int count_of(Section &, const std::string &key);
  /// `time_limit_s`: a number of seconds above 0.
  double time_limit_of(Section &, double by_default);
  /// A run's name is that of its files: a record elsewhere would be another run's.
  void check_run_name(Section &, const std::string &name);
} // namespace verify
