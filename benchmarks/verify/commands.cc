#include "commands.h"

#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_files.h"
#include "drift.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    const char *const suites[] = {"smoke", "quick", "full"};

    /// A run that went wrong: its last words are in most cases the reason.
    void print_trouble(const std::string &name, const Job &job, const Outcome &outcome)
    {
      fmt::print("  run {}: {} (exit code {})\n", name, outcome.status, outcome.exit_code);
      std::istringstream words(outcome.log_tail);
      for (std::string line; std::getline(words, line);)
        fmt::print("    | {}\n", line);
      if (fs::exists(job.command.log))
        fmt::print("    log: {}\n", job.command.log);
      fmt::print("    repeat with: {}\n", shell(job.command.arguments));
    }

    void print_case(const CaseResult &result)
    {
      fmt::print("\n{} ({})\n", result.c.name, result.c.title);
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
      {
        const auto &outcome = result.outcomes[i];
        if (!outcome.good())
          print_trouble(result.c.runs[i].name, result.jobs[i], outcome);
      }
      for (const auto &v : result.verdicts)
      {
        const std::string value = v.value ? fmt::format("{:.4g}", *v.value) : "-";
        const std::string error = v.uncertainty ? fmt::format(" +- {:.2g}", *v.uncertainty) : "";
        const std::string unit = value_unit(v.check);
        fmt::print("  {:12} {:60} {:>10}{} of {} {}\n", text(v.status), v.check.name, value, error,
                   limit_text(v.check), unit == "-" ? "" : unit);
        if (v.status != Status::pass)
          fmt::print("{:15}{}\n", "", v.why);
        if (v.drift.drifted)
          fmt::print("{:15}drift: accepted {:.6g}, tolerance {:.2g}\n", "", *v.drift.accepted,
                     v.drift.tolerance);
        if (v.drift.unknown && v.status == Status::pass)
          fmt::print("{:15}no accepted value to drift from: see --accept\n", "");
      }
    }

    void print_sum(const Campaign &campaign, const Paths &paths)
    {
      int passed = 0, failed = 0, drifted = 0, unknown = 0, forecasts = 0;
      double cpu = 0.;
      for (const auto &result : campaign.cases)
      {
        bool bad = false;
        for (const auto &v : result.verdicts)
        {
          (v.status == Status::pass ? passed : failed) += 1;
          drifted += v.drift.drifted ? 1 : 0;
          unknown += v.drift.unknown && v.status == Status::pass ? 1 : 0;
          forecasts += is_forecast(v) ? 1 : 0;
          bad |= v.status != Status::pass;
        }
        for (const auto &outcome : result.outcomes)
        {
          cpu += outcome.cpu_s;
          bad |= !outcome.good();
        }
        if (bad)
          fmt::print("repeat {} with: {}\n", result.c.name,
                     repeat_case(paths, result.c, campaign.options.output));
      }
      if (unknown > 0)
        fmt::print("\n{} checks passed without an accepted value to drift from", unknown);
      fmt::print(
          "\n{} checks passed, {} failed, {} drifted ({} of all are forecasts); {:.1f} s wall, "
          "{:.1f} s CPU; exit code {}\n",
          passed, failed, drifted, forecasts, campaign.wall_s, cpu, campaign.exit_code);
    }

    /// Cases that an earlier campaign has judged in the folder: they are in no sum of this one.
    void print_left_over(const Campaign &campaign)
    {
      const std::string &output = campaign.options.output;
      std::set<std::string> names;
      for (const auto &entry : fs::directory_iterator(output))
        if (fs::exists(entry.path() / "verdict.json"))
          names.insert(entry.path().filename().string());
      for (const auto &result : campaign.cases)
        names.erase(result.c.name);
      if (!names.empty())
        fmt::print("{0} holds verdicts of earlier campaigns as well, of {1}: campaign.json and the "
                   "report have this one's only; `verify run --suite {2} --output {0}` judges all "
                   "cases again and repeats no finished run\n",
                   output, fmt::join(names, ", "), campaign.options.suite);
    }
  } // namespace

  namespace
  {
    void list_case(const std::string &folder)
    {
      for (const char *suite : suites)
        if (takes_part(folder, suite))
        {
          const Case c = read_case(folder, suite);
          std::vector<std::string> runs;
          for (const auto &run : c.runs)
            runs.push_back(run.name);
          fmt::print("  {:6} {:60} {} checks; runs: {}\n", suite, c.title, c.checks.size(),
                     fmt::join(runs, ", "));
        }
    }
  } // namespace

  int list(const Paths &paths)
  {
    const auto names = case_names(paths);
    if (names.empty())
      throw BadInput(fmt::format("there is no case in {}: a case is a folder with an expect.toml",
                                 paths.cases));
    std::string errors; // of all files at once; the other cases are listed all the same
    for (const auto &name : names)
      try
      {
        fmt::print("{}\n", name);
        list_case(case_folder(paths, name));
      }
      catch (const BadInput &error)
      {
        errors += error.what();
      }
    if (!errors.empty())
      throw BadInput(errors);
    return 0;
  }

  namespace
  {
    void print_plan(const Paths &paths, const Case &c)
    {
      fmt::print("{}: {}\n{}\nsuite {}, scene {}\n\n", c.name, c.title, c.about, c.suite, c.scene);
      const auto jobs = jobs_of(c, paths, "results/" + c.suite);
      for (std::size_t i = 0; i < jobs.size(); ++i)
        fmt::print("run {} (at most {:.0f} s{}{})\n  {}\n", c.runs[i].name, c.runs[i].time_limit_s,
                   c.runs[i].expect_exit
                       ? fmt::format(", must end with exit code {}", c.runs[i].expect_exit)
                       : "",
                   jobs[i].unavailable ? "; its program is not built" : "",
                   shell(jobs[i].command.arguments));
      for (const auto &check : c.checks)
        fmt::print(
            "\ncheck {}\n  take     {}\n  against  {}\n  norm     {}, within [{:.6g}, {:.6g}] "
            "{}\n  source   {}\n  reason   {}\n",
            check.name, describe(check.take), describe(check.against), check.norm, check.low,
            check.high, value_unit(check), check.source, check.reason);
    }
  } // namespace

  int plan(const Paths &paths, const std::vector<std::string> &cases, const std::string &suite)
  {
    const char *gap = "";
    for (const auto &c : read_cases(cases, suite, paths))
    {
      fmt::print("{}", gap);
      print_plan(paths, c);
      gap = "\n";
    }
    return 0;
  }

  std::string repeat_case(const Paths &paths, const Case &c, const std::string &output)
  {
    std::vector<std::string> words = {paths.program};
    words.insert(words.end(), paths.asked.begin(), paths.asked.end());
    for (const auto &word : {std::string("run"), c.name, std::string("--suite"), c.suite,
                             std::string("--output"), output})
      words.push_back(word);
    return shell(words);
  }

  int run(const Paths &paths, const CampaignOptions &options)
  {
    const Campaign campaign = run_campaign(options, paths);
    for (const auto &result : campaign.cases)
      print_case(result);
    print_sum(campaign, paths);
    print_left_over(campaign);
    report(paths, options.output);
    if (options.accept && !interrupted()) // last: whatever becomes of it, the verdicts are written
      accept(campaign);
    return campaign.exit_code;
  }

  int report(const Paths &paths, const std::string &folder)
  {
    const bool any = fs::exists(folder + "/campaign.json") || fs::exists(folder + "/tradeoff") ||
                     fs::exists(folder + "/stability");
    if (!any)
      throw BadInput(fmt::format("{} holds no campaign.json: no campaign was run there", folder));
    const int code = run_python(paths, "report.py", {folder});
    if (code == 0)
      fmt::print("report: {}/index.html\n", folder);
    else
      fmt::print("no report was written (see above); the numbers are in the JSON files of {}\n",
                 folder);
    return code == 0 ? 0 : 2;
  }

  namespace
  {
    int table(const Paths &paths, const char *script, const TableRequest &request)
    {
      std::vector<std::string> arguments{request.folder};
      if (!request.readme.empty())
        arguments.push_back(request.readme);
      return run_python(paths, script, arguments);
    }
  } // namespace

  int presets(const Paths &paths, const TableRequest &request)
  {
    return table(paths, "presets.py", request);
  }

  int modules(const Paths &paths, const TableRequest &request)
  {
    return table(paths, "report_modules.py", request);
  }

  int figures(const Paths &paths, const std::string &folder)
  {
    const int code = run_python(paths, "figures.py", {folder, "--cases", paths.cases});
    return code == 0 || code == 1 || code == 4 ? code : 2; // what figures.py documents
  }
} // namespace verify
