#include "run_ranges.h"

#include <cmath>

#include <fmt/format.h>

namespace verify
{
  int count_of(Section &section, const std::string &key)
  {
    const double count = section.number(key).value_or(1.);
    if (count >= 1. && count <= 1024. && count == std::floor(count))
      return static_cast<int>(count);
    section.add_error(key, fmt::format("a whole number from 1 to 1024, not {:g}", count));
    return 1;
  }

  double time_limit_of(Section &section, const double by_default)
  {
    const double limit = section.number("time_limit_s").value_or(by_default);
    if (!(limit > 0.) || std::isinf(limit))
      section.add_error("time_limit_s", fmt::format("a run gets some seconds, not {:g}; leave the "
                                                    "key out for the suite's limit",
                                                    limit));
    return limit;
  }

  void check_run_name(Section &section, const std::string &name)
  {
    const bool plain = !name.empty() && name.find_first_of("/\n") == std::string::npos &&
                       name != "." && name != "..";
    if (!plain)
      section.add_error("name", fmt::format("`{}` names no file: a run's name is that of its "
                                            "record, without `/` or a line's end",
                                            name));
  }
} // namespace verify
