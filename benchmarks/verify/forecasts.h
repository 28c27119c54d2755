// What the solvers forecast of their own runs (`--plan`), and whether it came true: memory of the
// solver within 10 %, resident memory within 10 % + 50 MB, CPU time within a factor 2 (3 where
// finite elements choose their own steps or points are seeded during the run; of what such a run
// estimates at contact, 2 again).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "jobs.h"
#include "judge.h"

namespace verify
{
  struct Forecast
  {
    double cpu_s = 0., solver_bytes = 0., resident_bytes = 0.;
    std::map<std::string, double> bytes; // by module
    std::string on, off;                 // modules, as the solver names them
  };

  /// The job that asks for the plan of a run.
  Job forecast_job(const Job &run);

  /// From the log of such a job; empty if the solver predicted nothing.
  std::optional<Forecast> read_forecast(const std::string &log);

  /// Adds `forecast` to a run as run_to_json wrote it: what was predicted, what was measured, and
  /// for memory and time "met", "missed" or "not judged" (too short to say, or not recorded).
  void add_forecast(const std::optional<Forecast> &, nlohmann::ordered_json &run);

  /// The check that a run's forecast is: its worst miss as a part of what is allowed.
  Verdict forecast_verdict(const nlohmann::ordered_json &run);

  /// The check that the forecasts of the short runs of a case are together: their CPU time,
  /// predicted and measured, where either sum is so long as to count. Empty where it is not.
  std::optional<Verdict> short_runs_verdict(const std::vector<nlohmann::ordered_json> &runs);
  bool is_forecast(const Verdict &);
} // namespace verify
