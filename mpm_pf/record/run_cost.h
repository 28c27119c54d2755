// What a run costs from its first start to its end, over all interruptions.
//
// A checkpoint carries the profile of what was spent until then; a resumed run adds its own, so
// that the times of a record belong to the same run as its steps. What was computed after the last
// checkpoint and lost is in no profile.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/checkpoint.h"
#include "record/stopwatch.h"
#include "record/writer.h"

namespace record
{
  /// What the solver itself counts since this start of its program.
  struct SolverCost
  {
    Profile::Part output;                  // what observing took
    long steps = 0;                        // of the whole run: calls of "solve"
    std::vector<Profile::Part> parts;      // within the solve
    std::map<std::string, double> numbers; // state and sizes; bytes and calls since this start
  };

  /// Made when the program starts on its run.
  class RunCost
  {
  public:
    /// All until now was set-up; wall clock since this was made, CPU of the whole process.
    void set_up_done();

    /// Set-up, solve and output, the solver's parts, its numbers and `wall_s`, `cpu_s` (seconds),
    /// `peak_rss_bytes`, of the whole run until now: times and calls (numbers that end in `_calls`)
    /// are the sum over its starts, bytes ("bytes ...", `peak_rss_bytes`) the most of any.
    Profile profile(SolverCost) const;

    /// CPU seconds of the run until now, over its starts.
    double cpu_seconds() const;

    /// A number of the profile in the checkpoint that the run went on from, if it was there.
    std::optional<double> earlier(const std::string &number) const;

    /// The run goes on from `checkpoint`, in which save() put the profile until then.
    void resume(const Checkpoint &checkpoint);

  private:
    Stopwatch whole;
    Profile::Part setup{"set-up"};
    Profile before; // until the checkpoint
  };

  /// Into a checkpoint, below "spent".
  void save(const Profile &, CheckpointTarget &);
} // namespace record
