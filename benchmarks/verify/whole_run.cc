#include "whole_run.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <toml.hpp>

#include "quantity.h"

namespace verify
{
  namespace
  {
    /// End of the clock, if the scene gives it as a number and nothing else may end the run.
    std::optional<double> end_of_clock(const std::string &scene)
    {
      try
      {
        std::istringstream stream(scene);
        const toml::value root = toml::parse(stream, "the record's scene");
        if (!root.is_table() || root.contains("wall") || !root.contains("clock") ||
            !root.at("clock").contains("end"))
          return {};
        const toml::value &end = root.at("clock").at("end");
        if (end.is_floating())
          return end.as_floating();
        if (end.is_integer())
          return static_cast<double>(end.as_integer());
      }
      catch (const std::exception &)
      {
      }
      return {};
    }
  } // namespace

  void refuse_early_end(const record::Reader &reader, const std::vector<double> &times)
  {
    const auto end = end_of_clock(reader.scene_text());
    if (!end || times.empty() || !reader.attribute("ended_by").empty())
      return;
    double spacing = 1e-9 * *end;
    for (std::size_t i = 1; i < times.size(); ++i)
      spacing = std::max(spacing, times[i] - times[i - 1]);
    if (times.back() < *end - spacing * (1. + 1e-9))
      throw MissingData(fmt::format("short: recorded until time {}, and the clock ends at {}",
                                    times.back(), *end));
  }
} // namespace verify
