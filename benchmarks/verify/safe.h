// What a stability map knows to be safe, near the settings of a run that failed.
#pragma once

#include <string>

#include "expect.h"

namespace verify
{
  /// One sentence per map of <output>/stability/<case>.json that varies a setting of the run: the
  /// nearest accurate (else bounded) value of that setting. "" if no map knows better.
  std::string nearest_safe_setting(const std::string &output, const std::string &case_name,
                                   const Run &);
} // namespace verify
