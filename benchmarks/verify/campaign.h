// One campaign: the cases of a suite, their runs as processes, their checks, and what is written
// about them.
#pragma once

#include <string>
#include <vector>

#include "expect.h"
#include "forecasts.h"
#include "jobs.h"
#include "judge.h"
#include "paths.h"

namespace verify
{
  struct CampaignOptions
  {
    std::vector<std::string> cases; // empty: all
    std::string suite = "smoke";
    std::string output; // default: results/<suite>
    int cores = 0;      // 0: all of the machine
    bool fresh = false, accept = false;
  };

  /// What became of one case.
  struct CaseResult
  {
    Case c;
    std::vector<Job> jobs; // one per run
    std::vector<Outcome> outcomes;
    std::vector<Verdict> verdicts;
    std::vector<std::optional<Forecast>> forecasts; // one per run; empty: none was made
  };

  struct Campaign
  {
    CampaignOptions options;
    std::vector<CaseResult> cases;
    std::string started; // UTC
    double wall_s = 0.;
    int exit_code = 0;
  };

  /// The cases named (all that the suite has if none is), as they stand in the suite. Throws
  /// BadInput with every error of their files, accepted.toml included.
  std::vector<Case> read_cases(const std::vector<std::string> &named, const std::string &suite,
                               const Paths &);

  /// The process of one run, in the folder of its suite's records under `output`.
  Job job_of(const Run &, const Case &, const Paths &, const std::string &output);
  /// The jobs of one case, with their order of dependence.
  std::vector<Job> jobs_of(const Case &, const Paths &, const std::string &output);

  /// Runs, judges, writes campaign.json, verdict.json, curves.json and junit.xml. Throws BadInput
  /// before any work if an expect.toml or accepted.toml is wrong, or if another process runs cases
  /// into the folder. Accepts nothing: see drift.h.
  Campaign run_campaign(const CampaignOptions &, const Paths &);

  /// 0 all right, 1 a comparison failed or a run without its program is held against nothing, 2 a
  /// run found its input bad, 3 diverged or out of time, 4 reference missing, 5 drift only, 6 a
  /// record could not be written, 130 interrupted.
  int exit_code(const std::vector<CaseResult> &);

  /// The command that repeats one run or one case.
  std::string repeat_case(const Paths &, const Case &, const std::string &output);
} // namespace verify
