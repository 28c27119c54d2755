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

    toml::value scene_of(const record::Reader &reader)
    {
      std::istringstream stream(reader.scene_text());
      return toml::parse(stream, "the record's scene");
    }

    /// Until when a probe must have been recorded, if the scene tells and nothing else may end the
    /// run.
    std::optional<double> end_of(const record::Reader &reader, const std::string &probe)
    {
      if (may_end_early(reader))
        return {};
      try
      {
        const toml::value root = scene_of(reader);
        if (!root.contains("clock") || !root.at("clock").contains("end"))
          return {};
        const auto clock = number(root.at("clock").at("end"));
        const auto listed = last_listed(root, probe);
        return clock && listed ? std::min(*clock, *listed) : clock;
      }
      catch (const std::exception &) // a scene that this program cannot read says nothing
      {
        return {};
      }
    }

    void refuse_end_before(const double last, const double end, const double slack)
    {
      if (last < end - slack * (1. + 1e-9))
        throw MissingData(
            fmt::format("short: recorded until time {}, and the clock ends at {}", last, end));
    }
  } // namespace

  bool may_end_early(const record::Reader &reader)
  {
    try
    {
      return !reader.attribute("ended_by").empty() || walls_move(scene_of(reader));
    }
    catch (const std::exception &) // a scene that this program cannot read
    {
      return true;
    }
  }

  void refuse_early_end(const record::Reader &reader, const std::string &table,
                        const std::vector<double> &times)
  {
    const auto end = end_of(reader, table);
    if (!end || times.empty())
      return;
    double spacing = 1e-9 * *end;
    for (std::size_t i = 1; i < times.size(); ++i)
      spacing = std::max(spacing, times[i] - times[i - 1]);
    refuse_end_before(times.back(), *end, spacing);
  }

  void refuse_early_end(const record::Reader &reader, const std::string &probe,
                        const std::vector<double> &times, const double part)
  {
    if (const auto end = end_of(reader, probe); end && !times.empty())
      refuse_end_before(times.back(), *end, part * *end);
  }
} // namespace verify
