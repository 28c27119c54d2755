#include "history_end.h"

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
    std::optional<double> number(const toml::value &value)
    {
      if (value.is_floating())
        return value.as_floating();
      return value.is_integer() ? std::optional<double>(value.as_integer()) : std::nullopt;
    }

    /// The last of the times that the scene lists for a probe, if it lists any.
    std::optional<double> last_listed(const toml::value &root, const std::string &name)
    {
      if (!root.contains("probe") || !root.at("probe").is_array())
        return {};
      for (const auto &probe : root.at("probe").as_array())
        if (probe.contains("name") && probe.at("name").is_string() &&
            probe.at("name").as_string() == name && probe.contains("times"))
          return number(probe.at("times").as_array().back());
      return {};
    }

    /// Does a wall move? A run ends where its moving walls have travelled.
    bool walls_move(const toml::value &root)
    {
      const auto positive = [](const toml::value &wall, const char *key)
      { return wall.contains(key) && number(wall.at(key)).value_or(1.) > 0.; };
      if (!root.contains("wall") || !root.at("wall").is_array())
        return false;
      const auto &walls = root.at("wall").as_array();
      return std::any_of(walls.begin(), walls.end(),
                         [&](const toml::value &wall)
                         { return positive(wall, "speed") && positive(wall, "travel"); });
    }

    /// Until when a table must have been recorded, if the scene tells and nothing else may end the
    /// run.
    std::optional<double> end_of(const std::string &scene, const std::string &table)
    {
      try
      {
        std::istringstream stream(scene);
        const toml::value root = toml::parse(stream, "the record's scene");
        if (walls_move(root) || !root.contains("clock") || !root.at("clock").contains("end"))
          return {};
        const auto clock = number(root.at("clock").at("end"));
        const auto listed = last_listed(root, table);
        return clock && listed ? std::min(*clock, *listed) : clock;
      }
      catch (const std::exception &) // a scene that this program cannot read says nothing
      {
        return {};
      }
    }
  } // namespace

  void refuse_early_end(const record::Reader &reader, const std::string &table,
                        const std::vector<double> &times)
  {
    const auto end = end_of(reader.scene_text(), table);
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
