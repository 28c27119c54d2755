#include "campaign.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include <boost/algorithm/string/replace.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "campaign_files.h"
#include "drift.h"
#include "record/command_line.h"
#include "record/stopwatch.h"
#include "safe_settings.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    /// "{run}" in a setting becomes the path of that run's record.
    std::string with_records(std::string setting, const std::vector<std::string> &needs,
                             const std::string &folder)
    {
      for (const auto &run : needs)
      {
        const std::string record = fs::absolute(folder + "/" + run + ".h5").string();
        boost::algorithm::replace_all(setting, "{" + run + "}", record); // a folder may hold it
      }
      return setting;
    }

    std::vector<std::string> arguments_of(const Run &run, const Job &job, const Paths &paths,
                                          const std::string &folder)
    {
      std::vector<std::string> arguments;
      if (run.processes > 1)
        arguments = {"mpirun", "--oversubscribe", "-np", std::to_string(run.processes)};
      arguments.push_back(paths.solver(run.solver));
      arguments.push_back(job.scene);
      for (const auto &setting : job.set)
      {
        arguments.push_back("--set");
        arguments.push_back(setting);
      }
      for (const auto &argument :
           {std::string("--output"), folder, std::string("--record"), run.name,
            std::string("--threads"), std::to_string(run.threads), std::string("--force")})
        arguments.push_back(argument);
      return arguments;
    }

    /// Does the log hold what the run must say? Only asked of runs that name it.
    void check_output(const Run &run, const Job &job, Outcome &outcome)
    {
      if (run.expect_output.empty() || !outcome.good())
        return;
      std::ifstream stream(job.command.log);
      std::stringstream log;
      log << stream.rdbuf();
      std::string why = "its output does not contain `" + run.expect_output + "`";
      try
      {
        if (std::regex_search(log.str(), std::regex(run.expect_output, std::regex::icase)))
          return;
      }
      catch (const std::regex_error &error) // the pattern is one, and this log too much for it
      {
        why = "`" + run.expect_output + "` cannot be looked for in its output: " + error.what();
      }
      outcome.status = "failed";
      outcome.log_tail = why + ":\n" + log.str();
    }

    /// An absent program of the reference is an absent reference, not a wrong solver; but where
    /// what is judged is absent as well, nothing at all was compared.
    void tell_absent_references(CaseResult &result)
    {
      std::set<std::string> absent;
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
        if (result.outcomes[i].status == "no program")
          absent.insert(result.c.runs[i].name);
      const auto any_absent = [&](const std::set<std::string> &runs)
      {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const std::string &run) { return absent.count(run) > 0; });
      };
      for (auto &verdict : result.verdicts)
        if (verdict.status == Status::missing && verdict.check.against.kind == Against::Kind::run &&
            any_absent(runs_of(verdict.check.against.take)) &&
            !any_absent(runs_taken_by(verdict.check)))
          verdict.status = Status::no_reference;
    }

    /// A case of which nothing is asked must not pass.
    void refuse_silence(CaseResult &result)
    {
      const auto &runs = result.c.runs;
      const bool must_fail = std::any_of(runs.begin(), runs.end(),
                                         [](const Run &run) { return run.expect_exit != 0; });
      if (!result.c.checks.empty() || must_fail)
        return;
      Verdict nothing;
      nothing.check.name = "what must come out";
      nothing.check.norm = "value";
      nothing.check.source = result.c.folder + "/expect.toml";
      nothing.check.reason = "silence never passes";
      nothing.why = fmt::format("{} has no [[check]] for suite {}, and no run that must fail: "
                                "nothing was asked; add a [[check]], or expect_exit",
                                nothing.check.source, result.c.suite);
      result.verdicts.push_back(nothing);
    }

    void judge_case(CaseResult &result, const std::string &output)
    {
      std::map<std::string, std::string> unusable;
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
      {
        check_output(result.c.runs[i], result.jobs[i], result.outcomes[i]);
        if (result.outcomes[i].status == "diverged")
          result.outcomes[i].log_tail += nearest_safe_setting(output, result.c, result.c.runs[i]);
        if (!result.outcomes[i].good())
          unusable[result.c.runs[i].name] = fmt::format(
              "{} (exit code {})", result.outcomes[i].status, result.outcomes[i].exit_code);
      }
      Records records(output + "/" + result.c.name + "/" + scene_stem(result.c.suite), unusable);
      for (const auto &check : result.c.checks)
        result.verdicts.push_back(judge(check, result.c, records));
      tell_absent_references(result);
      refuse_silence(result);
      compare_with_accepted(result.verdicts, result.c);
    }

    /// Asks the solvers what the runs that came to an end should have cost, and judges that.
    void make_forecasts(Campaign &campaign)
    {
      std::vector<Job> plans;
      for (const auto &result : campaign.cases)
        for (std::size_t i = 0; i < result.jobs.size(); ++i)
          if (result.outcomes[i].status == "complete")
            plans.push_back(forecast_job(result.jobs[i]));
      if (!interrupted())
        run_jobs(plans, {campaign.options.cores, campaign.options.fresh});
      for (auto &result : campaign.cases)
      {
        std::vector<Json> runs;
        for (std::size_t i = 0; i < result.jobs.size(); ++i)
        {
          result.forecasts.emplace_back();
          if (result.outcomes[i].status != "complete" || interrupted())
            continue;
          result.forecasts.back() = read_forecast(forecast_job(result.jobs[i]).command.log);
          Json run = run_to_json(result.c.runs[i], result.jobs[i], result.outcomes[i]);
          add_forecast(result.forecasts.back(), run);
          result.verdicts.push_back(forecast_verdict(run));
          runs.push_back(run);
        }
        if (const auto verdict = short_runs_verdict(runs))
          result.verdicts.push_back(*verdict);
      }
    }
  } // namespace

  Job job_of(const Run &run, const Case &c, const Paths &paths, const std::string &output)
  {
    const std::string folder = output + "/" + c.name + "/" + scene_stem(c.suite);
    Job job;
    job.name = c.name + "/" + scene_stem(c.suite) + "/" + run.name;
    job.base = folder + "/" + run.name;
    job.scene = c.folder + "/" + run.scene;
    for (const auto &setting : run.set)
      job.set.push_back(with_records(setting, run.needs, folder));
    job.command.arguments = arguments_of(run, job, paths, folder);
    job.command.environment = {{"OMP_NUM_THREADS", std::to_string(run.threads)},
                               {"DEAL_II_NUM_THREADS", std::to_string(run.threads)},
                               {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                               {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"}};
    job.command.log = job.base + ".log";
    job.command.time_limit_s = run.time_limit_s;
    job.cores = job.command.cores = run.threads * run.processes;
    job.expect_exit = run.expect_exit;
    const std::string program = paths.solver(run.solver);
    job.unavailable = !fs::exists(program);
    std::string identity =
        hash_of_scene(c.folder + "/" + run.scene, run.set) + hash_of_file(program);
    for (const auto &argument : job.command.arguments)
      identity += " " + argument;
    job.hash = hash_of(identity);
    return job;
  }

  std::vector<Job> jobs_of(const Case &c, const Paths &paths, const std::string &output)
  {
    std::vector<Job> jobs;
    for (const auto &run : c.runs)
      jobs.push_back(job_of(run, c, paths, output));
    for (std::size_t i = 0; i < jobs.size(); ++i)
      for (std::size_t k = 0; k < jobs.size(); ++k)
        if (std::count(c.runs[i].needs.begin(), c.runs[i].needs.end(), c.runs[k].name) > 0)
        {
          jobs[i].after.push_back(k);
          jobs[i].hash = hash_of(jobs[i].hash + jobs[k].hash);
        }
    return jobs;
  }

  std::vector<Case> read_cases(const std::vector<std::string> &named, const std::string &suite,
                               const Paths &paths)
  {
    std::vector<Case> cases;
    std::string errors;
    for (const auto &name : chosen_cases(named, paths))
    {
      const std::string folder = case_folder(paths, name);
      if (!takes_part(folder, suite))
      {
        if (!named.empty())
          errors += fmt::format("{} has no {}: it takes no part in suite {}\n", folder,
                                scene_file(suite), suite);
        continue;
      }
      try
      {
        cases.push_back(read_case(folder, suite));
      }
      catch (const BadInput &error)
      {
        errors += error.what();
      }
      try
      {
        check_accepted(folder);
      }
      catch (const BadInput &error)
      {
        errors += error.what();
      }
    }
    if (!errors.empty())
      throw BadInput(errors);
    if (cases.empty())
      throw BadInput("no case takes part in suite " + suite);
    return cases;
  }

  Campaign run_campaign(const CampaignOptions &options, const Paths &paths)
  {
    Campaign campaign;
    campaign.options = options;
    campaign.started = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
    const record::Stopwatch stopwatch;
    for (const auto &c : read_cases(options.cases, options.suite, paths))
      campaign.cases.push_back({c, {}, {}, {}, {}});
    const record::Lock lock = lock_output(options.output);
    std::vector<Job> all;
    for (auto &result : campaign.cases)
    {
      result.jobs = jobs_of(result.c, paths, options.output);
      const std::size_t first = all.size();
      for (Job job : result.jobs)
      {
        for (auto &index : job.after)
          index += first;
        all.push_back(job);
      }
    }
    const auto outcomes = run_jobs(all, {options.cores, options.fresh});
    std::size_t next = 0;
    for (auto &result : campaign.cases)
    {
      result.outcomes.assign(outcomes.begin() + static_cast<long>(next),
                             outcomes.begin() + static_cast<long>(next + result.jobs.size()));
      next += result.jobs.size();
      judge_case(result, options.output);
    }
    make_forecasts(campaign);
    campaign.wall_s = stopwatch.wall_seconds();
    campaign.exit_code = exit_code(campaign.cases);
    if (interrupted())
      campaign.exit_code = record::interrupted;
    write_campaign(campaign, paths);
    return campaign;
  }
} // namespace verify
