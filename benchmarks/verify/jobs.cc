#include "jobs.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "json_text.h"
#include "progress.h"
#include "record/atomic_write.h"
#include "record/checkpoint.h"
#include "record/command_line.h"
#include "record_mark.h"

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
             : ended.exit_code == record::not_written       ? "not written"
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
      Json state{{"hash", job.hash},
                 {"status", outcome.status},
                 {"exit_code", outcome.exit_code},
                 {"wall_s", outcome.wall_s},
                 {"cpu_s", outcome.cpu_s},
                 {"peak_rss_bytes", outcome.peak_rss_bytes},
                 {"time_limit_s", job.command.time_limit_s},
                 {"last_words", outcome.log_tail},
                 {"command", shell(job.command.arguments)}};
      if (const auto mark = mark_record(job.base + ".h5"); mark && job.makes_record)
        state["record"] = to_json(*mark);
      record::write_atomically(job.base + ".run.json", json_text(state));
    }

    /// Does the record lie there that this job, as it is now, has left?
    bool holds_its_record(const Job &job, const Json &state)
    {
      const auto left = mark_in(state), now = mark_record(job.base + ".h5");
      return left && now && *now == *left && other_scene(*now, job).empty();
    }

    /// The outcome of an earlier run of the very same job, if it can be kept.
    std::optional<Outcome> finished_before(const Job &job)
    {
      const auto state = state_beside(job.base);
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
      if (outcome.status == "not written")
        return {}; // there may be room by now; it says nothing of the settings
      if (outcome.status == "complete" && job.keep_record && job.makes_record &&
          !holds_its_record(job, state))
        return {};
      if (outcome.status == "failed" && outcome.exit_code == record::all_right)
        return {}; // without the record of its scene, for which the solver need not be to blame
      return outcome.good() || job.any_exit ? std::optional<Outcome>(outcome) : std::nullopt;
    }

    /// What the earlier starts of a run have cost that its solver can go on with: it was stopped
    /// and has left a checkpoint of the very same job.
    std::optional<Outcome> spent_before(const Job &job)
    {
      const std::string record = job.base + ".h5";
      const Json state = state_beside(job.base);
      if (!job.makes_record || !job.keep_record || !state.is_object() ||
          state.value("hash", "") != job.hash || !fs::exists(record + ".part") ||
          !fs::exists(record::checkpoint_path(record)))
        return {};
      Outcome spent;
      spent.status = state.value("status", "");
      spent.wall_s = state.value("wall_s", 0.);
      spent.cpu_s = state.value("cpu_s", 0.);
      spent.peak_rss_bytes = state.value("peak_rss_bytes", 0.);
      const bool stopped = spent.status == "timed out" || spent.status == "interrupted" ||
                           spent.status == "not written";
      return stopped ? std::optional<Outcome>(spent) : std::nullopt;
    }

    Command resuming(Command command)
    {
      std::replace(command.arguments.begin(), command.arguments.end(), std::string("--force"),
                   std::string("--resume"));
      return command;
    }

    Outcome finish(const Job &job, const ProcessResult &ended, const Outcome &spent)
    {
      Outcome outcome;
      outcome.exit_code = ended.exit_code;
      outcome.status = status_of(job, ended);
      outcome.wall_s = ended.wall_s + spent.wall_s;
      outcome.cpu_s = ended.cpu_s + spent.cpu_s;
      outcome.peak_rss_bytes = std::max(ended.peak_rss_bytes, spent.peak_rss_bytes);
      if (outcome.status == "complete" && job.makes_record && !fs::exists(job.base + ".h5"))
        outcome.status = "failed"; // exit code 0 without a record is a lie
      std::string doubt;
      if (outcome.status == "complete" && job.makes_record)
        if (const auto mark = mark_record(job.base + ".h5"))
          doubt = other_scene(*mark, job);
      if (!doubt.empty())
        outcome.status = "failed";
      if (!job.keep_record)
        for (const char *extension : {".h5", ".xdmf"})
          fs::remove(job.base + extension);
      if (!outcome.good())
        outcome.log_tail = doubt + log_tail(job.command.log);
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
      std::map<std::size_t, Outcome> spent = {}; // by earlier starts of those that go on
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
        const auto before = options.fresh ? std::nullopt : spent_before(job);
        spent[i] = before.value_or(Outcome{});
        fs::remove(job.base + ".run.json");
        running.emplace_back(i, Process(before ? resuming(job.command) : job.command));
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
            outcomes[i] = finish(jobs[i], *ended, spent[i]);
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
          const auto earlier = state_beside(queue.jobs[i].base);
          queue.progress.add_run(earlier.is_object() ? earlier.value("wall_s", 0.) : 0.);
        }
      }
    }
  } // namespace

  std::vector<Outcome> run_jobs(const std::vector<Job> &jobs, const JobOptions &options)
  {
    Queue queue{jobs,
                options,
                std::vector<std::optional<Outcome>>(jobs.size()),
                {},
                {},
                {},
                Progress(options.cores)};
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
