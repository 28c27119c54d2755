// tradeoff.toml: which settings buy speed, and what error is measured for it (README.md defines the
// format).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "expect.h"

namespace verify
{
  /// One setting of a run: a scene key and its value as TOML text.
  struct Setting
  {
    std::string key, value;
  };

  /// One measured set of settings.
  struct TradeRow
  {
    std::string family;
    std::vector<Setting> settings; // what the family varies
    Run run;
  };

  struct Trade
  {
    Case c; // folder, suite, scene, constants; runs: the references, then the rows
    std::vector<Check>
        measures; // one per quantity and norm, named "quantity, norm"; `take` without a run, and
                  // `against` without one where a row is held against a quantity of its own
    std::map<std::string, Take> takes_of_elements; // by measure: what a row of fe_reference has of
                                                   // it, where that lies under another name
    std::vector<std::string> references;
    std::vector<TradeRow> rows;
    std::string reference_text; // for people
  };

  /// Reads <folder>/tradeoff.toml. Throws BadInput with every error of the file.
  Trade read_trade(const std::string &folder);
} // namespace verify
