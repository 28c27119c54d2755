#include <algorithm>

#include "campaign.h"
#include "record/command_line.h"

namespace verify
{
  namespace
  {
    /// Does a check name the run? Then its verdict says what the absence of its program means.
    bool judged(const CaseResult &result, const std::string &run)
    {
      return std::any_of(result.c.checks.begin(), result.c.checks.end(),
                         [&](const Check &check) { return runs_of(check).count(run) > 0; });
    }
  } // namespace

  int exit_code(const std::vector<CaseResult> &cases)
  {
    bool failed = false, missing = false, no_reference = false, drifted = false, bad_input = false,
         diverged = false, broken = false, unwritten = false;
    for (const auto &result : cases)
    {
      for (const auto &verdict : result.verdicts)
      {
        failed |= verdict.status == Status::fail;
        missing |= verdict.status == Status::missing;
        no_reference |= verdict.status == Status::no_reference;
        drifted |= verdict.drift.drifted;
      }
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
      {
        const auto &outcome = result.outcomes[i];
        broken |= outcome.status == "no program" && !judged(result, result.c.runs[i].name);
        bad_input |= outcome.status == "bad input";
        diverged |= outcome.status == "diverged" || outcome.status == "timed out";
        broken |= outcome.status == "failed";
        unwritten |= outcome.status == "not written";
      }
    }
    // a comparison that was made and failed says more than a run that gave nothing to compare
    if (failed || (missing && !bad_input && !diverged && !unwritten) || broken)
      return record::comparison_failed;
    if (unwritten)
      return record::not_written;
    if (bad_input || diverged)
      return bad_input ? record::bad_input : record::numerical_trouble;
    return no_reference ? record::reference_missing
           : drifted    ? record::drift_only
                        : record::all_right;
  }
} // namespace verify
