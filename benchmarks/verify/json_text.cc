#include "json_text.h"

namespace verify
{
  std::string json_text(const Json &json, const bool one_line)
  {
    return json.dump(one_line ? -1 : 1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string as_utf8(const std::string &text)
  {
    return Json::parse(json_text(text)).get<std::string>();
  }
} // namespace verify
