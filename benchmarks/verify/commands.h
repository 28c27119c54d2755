// The commands of `verify`; each returns an exit code and prints its result on stdout.
#pragma once

#include <string>
#include <vector>

#include "campaign.h"
#include "paths.h"

namespace verify
{
  int list(const Paths &);
  int plan(const Paths &, const std::vector<std::string> &cases, const std::string &suite);
  int run(const Paths &, const CampaignOptions &);
  int report(const Paths &, const std::string &folder);
  int diff(const std::string &folder_a, const std::string &folder_b);
  int tradeoff(const Paths &, const std::string &case_name, const CampaignOptions &);
  struct AdviceRequest
  {
    std::string case_name, quantity;
    std::string error;  // "0.02" or "2%"
    std::string output; // where the trade was measured
  };
  int advise(const Paths &, const AdviceRequest &);
  int stability(const Paths &, const CampaignOptions &);
  struct TableRequest
  {
    std::string folder; // of the campaign
    std::string readme; // file that gets the table; "": stdout
  };
  /// Error and cost per preset and case, from what `tradeoff` measured.
  int presets(const Paths &, const TableRequest &);
  /// Modules, memory and time per case from campaign.json.
  int modules(const Paths &, const TableRequest &);
  /// 0 drawn, 1 a figure's own program failed, 2 bad input, 4 there is nothing to draw from.
  int figures(const Paths &, const std::string &folder);
} // namespace verify
