// Two campaigns side by side: which value moved, which status changed, what it cost.
#include <cmath>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "campaign_files.h"
#include "commands.h"
#include "section.h"

namespace verify
{
  namespace
  {
    Json read_campaign(const std::string &folder)
    {
      std::ifstream stream(folder + "/campaign.json");
      if (!stream)
        throw BadInput(fmt::format("{} holds no campaign.json", folder));
      Json json = Json::parse(stream, nullptr, false);
      if (json.is_discarded())
        throw BadInput(fmt::format("{}/campaign.json cannot be parsed", folder));
      return json;
    }

    /// "case / name" -> entry, of the checks or the runs.
    std::map<std::string, Json> entries(const Json &campaign, const std::string &kind)
    {
      std::map<std::string, Json> result;
      for (const auto &c : campaign.at("cases"))
        for (const auto &entry : c.at(kind))
          result[c.at("case").get<std::string>() + " / " + entry.at("name").get<std::string>()] =
              entry;
      return result;
    }

    std::string shown(const Json &value)
    {
      return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : "-";
    }

    bool differs(const Json &a, const Json &b)
    {
      return a.at("status") != b.at("status") || shown(a.at("value")) != shown(b.at("value"));
    }
  } // namespace

  int diff(const std::string &folder_a, const std::string &folder_b)
  {
    const Json a = read_campaign(folder_a), b = read_campaign(folder_b);
    const auto before = entries(a, "checks"), after = entries(b, "checks");
    int changed = 0;
    for (const auto &[name, check] : after)
    {
      const auto found = before.find(name);
      if (found != before.end() && !differs(found->second, check))
        continue;
      ++changed;
      fmt::print("{:70} {:>12} {:12} -> {:>12} {}\n", name,
                 found == before.end() ? "-" : shown(found->second.at("value")),
                 found == before.end() ? "new" : found->second.at("status").get<std::string>(),
                 shown(check.at("value")), check.at("status").get<std::string>());
    }
    for (const auto &[name, check] : before)
      if (after.count(name) == 0)
      {
        ++changed;
        fmt::print("{:70} {:>12} {:12} -> gone\n", name, shown(check.at("value")),
                   check.at("status").get<std::string>());
      }
    const auto runs_before = entries(a, "runs"), runs_after = entries(b, "runs");
    for (const auto &[name, run] : runs_after)
      if (const auto found = runs_before.find(name); found != runs_before.end())
      {
        const double old_cpu = found->second.at("cpu_s"), new_cpu = run.at("cpu_s");
        if (std::abs(new_cpu - old_cpu) > 0.2 * old_cpu + 0.2)
          fmt::print("{:70} {:10.2f} s CPU -> {:10.2f} s CPU\n", name, old_cpu, new_cpu);
      }
    fmt::print("{} of {} checks differ\n", changed, std::max(before.size(), after.size()));
    return changed == 0 ? 0 : 1;
  }
} // namespace verify
