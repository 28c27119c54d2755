#include "jobs.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "json_text.h"
#include "progress.h"
#include "record/atomic_write.h"
#include "record/command_line.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    std::string status_of(const Job &job, const ProcessResult &ended)
    {
      if (ended.timed_out) // when told to stop it may leave with any code but that of trouble
        return ended.exit_code == record::numerical_trouble ? "diverged" : "timed out";
      if (ended.interrupted || ended.exit_code == record::interrupted)
        return "interrupted";
      if (ended.exit_code == job.expect_exit)
        return job.expect_exit == 0 ? "complete" : "as expected";
      return ended.exit_code == record::bad_input           ? "bad input"
             : ended.exit_code == record::numerical_trouble ? "diverged"
                                                            : "failed";
    }

    // The last lines of a log: of a run that failed, those that say why and no banner before them.
    std::string log_tail(const std::string &log)
    {
      std::ifstream stream(log);
      std::vector<std::string> lines;
      std::size_t reason = 0;
      for (std::string line; std::getline(stream, line); lines.push_back(line))
        if (line.find(": failed in ") != std::string::npos)
          reason = lines.size() + 1;
      const std::size_t last_twelve = lines.size() > 12 ? lines.size() - 12 : 0;
      const std::size_t begin = reason < lines.size() ? std::max(reason, last_twelve) : last_twelve;
      std::string text;
      for (std::size_t i = begin; i < lines.size(); ++i)
        text += lines[i] + "\n";
      return text;
    }

    void write_state(const Job &job, const Outcome &outcome)
    {
      const Json state{{"hash", job.hash},
                       {"status", outcome.status},
                       {"exit_code", outcome.exit_code},
                       {"wall_s", outcome.wall_s},
                       {"cpu_s", outcome.cpu_s},
                       {"peak_rss_bytes", outcome.peak_rss_bytes},
                       {"time_limit_s", job.command.time_limit_s},
                       {"last_words", outcome.log_tail},
                       {"command", shell(job.command.arguments)}};
      record::write_atomically(job.base + ".run.json", json_text(state));
    }

    Json read_state(const Job &job)
    {
      std::ifstream stream(job.base + ".run.json");
      return stream ? Json::parse(stream, nullptr, false) : Json();
    }

    /// The outcome of an earlier run of the very same job, if it can be kept.
    std::optional<Outcome> finished_before(const Job &job)
    {
      const auto state = read_state(job);
      if (!state.is_object() || state.value("hash", "") != job.hash)
        return {};
      Outcome outcome;
      outcome.status = state.value("status", "");
      outcome.exit_code = state.value("exit_code", -1);
      outcome.wall_s = state.value("wall_s", 0.);
      outcome.cpu_s = state.value("cpu_s", 0.);
      outcome.peak_rss_bytes = state.value("peak_rss_bytes", 0.);
      outcome.log_tail = state.value("last_words", "");
      outcome.reused = true;
      const bool longer = job.command.time_limit_s > state.value("time_limit_s", 0.);
      if (outcome.status == "interrupted" || (outcome.status == "timed out" && longer))
        return {};
      if (outcome.status == "complete" && job.keep_record && !fs::exists(job.base + ".h5"))
        return {};
      return outcome.good() || job.any_exit ? std::optional<Outcome>(outcome) : std::nullopt;
    }

    Outcome finish(const Job &job, const ProcessResult &ended)
    {
      Outcome outcome;
      outcome.exit_code = ended.exit_code;
      outcome.status = status_of(job, ended);
      outcome.wall_s = ended.wall_s;
      outcome.cpu_s = ended.cpu_s;
      outcome.peak_rss_bytes = ended.peak_rss_bytes;
      if (outcome.status == "complete" && job.makes_record && !fs::exists(job.base + ".h5"))
        outcome.status = "failed"; // exit code 0 without a record is a lie
      if (!job.keep_record)
        for (const char *extension : {".h5", ".xdmf"})
          fs::remove(job.base + extension);
      if (!outcome.good())
        outcome.log_tail = log_tail(job.command.log);
      if (ended.timed_out && outcome.status == "diverged")
        outcome.log_tail =
            fmt::format("it met trouble, and its time limit of {:g} s ended it on the way back to "
                        "the last good state\n",
                        job.command.time_limit_s) +
            outcome.log_tail;
      write_state(job, outcome);
      return outcome;
    }

    /// What is under way and what still waits.
    struct Queue
    {
      const std::vector<Job> &jobs;
      const JobOptions &options;
      std::vector<std::optional<Outcome>> outcomes;
      std::vector<std::pair<std::size_t, Process>> running;
      std::vector<std::size_t> waiting;
      Progress progress;

      bool may_start(const std::size_t i) const
      {
        int busy = 0;
        for (const auto &[k, process] : running)
          busy += jobs[k].cores;
        if (!running.empty() && busy + jobs[i].cores > options.cores)
          return false;
        return std::all_of(jobs[i].after.begin(), jobs[i].after.end(),
                           [&](std::size_t k) { return outcomes[k].has_value(); });
      }

      void start(const std::size_t i)
      {
        const Job &job = jobs[i];
        const bool orphan = std::any_of(job.after.begin(), job.after.end(),
                                        [&](std::size_t k) { return !outcomes[k]->good(); });
        if (job.unavailable || orphan)
        {
          Outcome outcome;
          outcome.status = job.unavailable ? "no program" : "failed";
          outcome.exit_code = -1;
          outcome.log_tail = job.unavailable
                                 ? job.command.arguments[0] + " is not there: build it first\n"
                                 : "a run that this one needs did not finish\n";
          outcomes[i] = outcome;
          progress.done(job.name, outcome.status, 0.);
          return;
        }
        fs::create_directories(fs::path(job.base).parent_path());
        fs::remove(job.base + ".run.json");
        running.emplace_back(i, Process(job.command));
      }

      void collect()
      {
        for (std::size_t r = 0; r < running.size();)
        {
          auto &[i, process] = running[r];
          if (interrupted())
            process.interrupt();
          if (const auto ended = process.poll())
          {
            outcomes[i] = finish(jobs[i], *ended);
            progress.done(jobs[i].name, outcomes[i]->status, outcomes[i]->wall_s);
            running.erase(running.begin() + static_cast<long>(r));
          }
          else
            ++r;
        }
      }
    };

    void reuse_finished(Queue &queue)
    {
      for (std::size_t i = 0; i < queue.jobs.size(); ++i)
      {
        if (!queue.options.fresh)
          queue.outcomes[i] = finished_before(queue.jobs[i]);
        if (!queue.outcomes[i])
        {
          queue.waiting.push_back(i);
          const auto earlier = read_state(queue.jobs[i]);
          queue.progress.add_run(earlier.is_object() ? earlier.value("wall_s", 0.) : 0.);
        }
      }
    }
  } // namespace

  std::vector<Outcome> run_jobs(const std::vector<Job> &jobs, const JobOptions &options)
  {
    Queue queue{jobs, options, std::vector<std::optional<Outcome>>(jobs.size()),
                {},   {},      Progress(options.cores)};
    reuse_finished(queue);
    while ((!queue.waiting.empty() && !interrupted()) || !queue.running.empty())
    {
      bool stuck = queue.running.empty();
      for (auto i = queue.waiting.begin(); i != queue.waiting.end() && !interrupted();)
        if (queue.may_start(*i))
        {
          queue.start(*i);
          i = queue.waiting.erase(i);
          stuck = false;
        }
        else
          ++i;
      if (stuck && !interrupted())
        throw std::logic_error("jobs wait for each other: " + jobs[queue.waiting.front()].name);
      queue.collect();
      queue.progress.show(queue.running.size());
      if (!queue.running.empty())
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::vector<Outcome> outcomes;
    for (const auto &outcome : queue.outcomes)
      outcomes.push_back(outcome.value_or(Outcome{"interrupted", 130, 0., 0., 0., false, ""}));
    return outcomes;
  }
} // namespace verify
