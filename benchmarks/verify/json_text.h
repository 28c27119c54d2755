// JSON as this program writes it. Solvers' logs go into it, and a log may hold any bytes: what is
// no UTF-8 is replaced, for neither JSON nor XML may hold it.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace verify
{
  using Json = nlohmann::ordered_json;

  /// The text of a file: indented by one space a level, or on one line, with a line end.
  std::string json_text(const Json &, bool one_line = false);
  /// The same text with U+FFFD for every byte that is no UTF-8.
  std::string as_utf8(const std::string &);
} // namespace verify
