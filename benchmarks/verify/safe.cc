#include "safe.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace verify
{
  namespace
  {
    using Json = nlohmann::json;

    std::optional<double> as_number(const std::string &text)
    {
      char *end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0' ? std::optional<double>(value) : std::nullopt;
    }

    /// The run's own value of the axis, if one of its settings is the axis' template with a number
    /// in it.
    std::optional<double> value_on(const Json &axis, const Run &run)
    {
      for (const std::string &form : axis.value("set", std::vector<std::string>()))
      {
        const std::string key = form.substr(0, form.find('='));
        for (const auto &setting : run.set)
          if (setting.rfind(key + "=", 0) == 0)
            return as_number(setting.substr(key.size() + 1));
      }
      return {};
    }

    /// The accurate cell nearest to `value` on x, else the nearest bounded one; null if there is
    /// none.
    const Json *nearest(const Json &map, const double value)
    {
      const Json *best = nullptr;
      double smallest = INFINITY;
      for (const char *wanted : {"accurate", "bounded but wrong"})
      {
        for (const auto &cell : map.at("cells"))
          if (const auto x = as_number(cell.at("x")); cell.at("class") == wanted && x)
            if (std::abs(*x - value) < smallest)
            {
              smallest = std::abs(*x - value);
              best = &cell;
            }
        if (best)
          return best;
      }
      return nullptr;
    }
  } // namespace

  std::string nearest_safe_setting(const std::string &output, const std::string &case_name,
                                   const Run &run)
  {
    std::ifstream stream(output + "/stability/" + case_name + ".json");
    const Json stability = stream ? Json::parse(stream, nullptr, false) : Json();
    std::string text;
    if (!stability.is_object())
      return text;
    for (const auto &map : stability.at("maps"))
      if (const auto value = value_on(map.at("x"), run))
        if (const Json *cell = nearest(map, *value))
          text +=
              fmt::format("known to be {}: {} = {} ({})\n", cell->at("class").get<std::string>(),
                          map.at("x").at("label").get<std::string>(),
                          cell->at("x").get<std::string>(), map.at("name").get<std::string>());
    return text;
  }
} // namespace verify
