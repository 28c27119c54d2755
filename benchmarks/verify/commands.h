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
  int advise(const Paths &, const std::string &case_name, const std::string &quantity,
             const std::string &error, const std::string &output);
  int stability(const Paths &, const CampaignOptions &);
  /// Error and cost per preset and case, from what `tradeoff` measured: on stdout, or into `readme`
  /// if it is not empty.
  int presets(const Paths &, const std::string &folder, const std::string &readme);
  /// Modules, memory and time per case from campaign.json: printed, or written into `readme`.
  int modules(const Paths &, const std::string &folder, const std::string &readme);
  /// 0 drawn, 1 a figure's own program failed, 2 bad input, 4 there is nothing to draw from.
  int figures(const Paths &, const std::string &folder);
} // namespace verify
