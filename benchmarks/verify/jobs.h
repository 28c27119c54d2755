// A list of solver runs, done in parallel: finished ones are recognised and not repeated, a kill
// loses at most the runs under way.
#pragma once

#include <string>
#include <vector>

#include "process.h"

namespace verify
{
  struct Job
  {
    std::string name;             // for people: case/suite/run
    std::string base;             // path of record, log and state without extension
    std::string scene;            // its file
    std::vector<std::string> set; // overrides of it, as on the command line
    Command command;
    int cores = 1;
    int expect_exit = 0;
    bool any_exit =
        false; // a failure is a finding, too (tradeoff, stability): it is kept and not repeated
    bool unavailable = false; // its program is not there
    bool makes_record = true; // false: it only says something (--plan)
    bool keep_record = true;  // else only its cost matters: the record goes when the run is over
    std::string hash;         // of scene, settings and program
    std::vector<std::size_t> after; // indices of the jobs that must be finished first

    std::string record_name() const { return base.substr(base.rfind('/') + 1); }
  };

  struct Outcome
  {
    std::string status; // complete, as expected, bad input, diverged, timed out, failed, not
                        // written (no room for its record), interrupted, no program
    int exit_code = 0;
    double wall_s = 0., cpu_s = 0., peak_rss_bytes = 0.;
    bool reused = false;
    std::string log_tail; // end of the log, if it went wrong
    bool good() const { return status == "complete" || status == "as expected"; }
  };

  struct JobOptions
  {
    int cores = 1;
    bool fresh = false; // repeat finished runs
  };

  /// Runs them; progress and estimated time left on stderr. Stops early when interrupted
  /// (outcomes say so).
  std::vector<Outcome> run_jobs(const std::vector<Job> &, const JobOptions &);

  /// 64-bit FNV-1a of a text as 16 hex digits; of a file's content ("absent" if it cannot be
  /// read).
  std::string hash_of(const std::string &text);
  std::string hash_of_file(const std::string &path);
  /// Hash of a scene file and of all files that it, or the overrides `set`, name in quotes.
  std::string hash_of_scene(const std::string &path, const std::vector<std::string> &set = {});

  /// The command with shell quoting.
  std::string shell(const std::vector<std::string> &arguments);
} // namespace verify
