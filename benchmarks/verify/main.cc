// verify: argv -> command -> exit code; the only try/catch.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "record/command_line.h"
#include "scene/nearest_name.h"
#include "section.h"

namespace
{
  using namespace verify;

  struct Arguments
  {
    std::string cases, solvers, name, other, suite, output, quantity, error, readme;
    CampaignOptions campaign;
  };

  CLI::Option *add_suite(CLI::App *app, std::string &suite)
  {
    return app->add_option("--suite", suite, "smoke, quick or full")
        ->check(CLI::IsMember({"smoke", "quick", "full"}));
  }

  void add_cores(CLI::App *app, Arguments &a)
  {
    app->add_option("-j", a.campaign.cores, "cores to use (default: all)")
        ->check(CLI::Range(1, 1024));
  }

  void add_run(CLI::App &app, Arguments &a)
  {
    auto *run = app.add_subcommand("run", "run cases, judge them, write the report");
    run->add_option("case", a.campaign.cases, "cases (default: all that the suite has)");
    add_suite(run, a.campaign.suite);
    add_cores(run, a);
    run->add_option("--output", a.output, "folder of the campaign (default: results/<suite>)");
    run->add_flag("--fresh", a.campaign.fresh, "repeat runs that are finished");
    run->add_flag("--accept", a.campaign.accept,
                  "make the values of what passes the accepted ones");
  }

  void add_others(CLI::App &app, Arguments &a)
  {
    app.add_subcommand("list", "every case, its suites, runs and checks");
    auto *plan = app.add_subcommand("plan", "what would run and be checked; runs nothing");
    plan->add_option("case", a.campaign.cases, "cases (default: all that the suite has)");
    add_suite(plan, a.suite);
    app.add_subcommand("report", "write the report again")
        ->add_option("folder", a.name)
        ->required();
    auto *diff = app.add_subcommand("diff", "two campaigns side by side");
    diff->add_option("folder_a", a.name)->required();
    diff->add_option("folder_b", a.other)->required();
    app.add_subcommand("figures", "the figures of the paper, from the records of a campaign")
        ->add_option("--output", a.output, "folder of the campaign (default: results/full)");
  }

  void add_trade(CLI::App &app, Arguments &a)
  {
    const auto add_common = [&](CLI::App *command)
    {
      add_cores(command, a);
      command->add_option(
          "--output", a.output,
          "folder of the results (default: results/<suite>, of a trade results/full)");
      command->add_flag("--fresh", a.campaign.fresh, "repeat runs that are finished");
    };
    auto *trade =
        app.add_subcommand("tradeoff", "error against cost for the settings of tradeoff.toml");
    trade->add_option("case", a.campaign.cases, "cases (default: all that can be traded)");
    add_common(trade);
    auto *map = app.add_subcommand("stability", "classes over the axes of stability.toml");
    map->add_option("case", a.campaign.cases, "cases (default: all that have a stability.toml)");
    add_suite(map, a.campaign.suite);
    add_common(map);
    auto *advice =
        app.add_subcommand("advise", "the cheapest measured settings that meet an error");
    advice->add_option("case", a.name)->required();
    advice->add_option("--quantity", a.quantity, "as named in tradeoff.toml")->required();
    advice->add_option("--error", a.error, "0.02 or 2%")->required();
    advice->add_option("--output", a.output,
                       "where the trade was measured (default: results/full)");
  }

  void add_presets(CLI::App &app, Arguments &a)
  {
    auto *presets = app.add_subcommand(
        "presets", "error and cost per preset and case, from what tradeoff measured");
    presets->add_option("--output", a.output, "where it was measured (default: results/full)");
    presets->add_option("--readme", a.readme, "write the table between the marks of this file");
    auto *modules = app.add_subcommand(
        "modules", "modules, memory and time per case, predicted and measured, from a campaign");
    modules->add_option("--output", a.output, "folder of the campaign (default: results/quick)");
    modules->add_option("--readme", a.readme, "write the table between the marks of this file");
  }

  /// The worst exit code of the cases; one that cannot be traded is only told of, unless it was
  /// named.
  int trade_all(const Paths &paths, const CampaignOptions &options)
  {
    int worst = 0;
    for (const auto &name : chosen_cases(options.cases, paths))
      try
      {
        const int code = tradeoff(paths, name, options);
        if (code == record::interrupted)
          return code;
        worst = std::max(worst, code);
      }
      catch (const BadInput &error)
      {
        if (!options.cases.empty())
          throw;
        fmt::print(stderr, "{}: {}\n", name, error.what());
      }
    return worst;
  }

  int dispatch(CLI::App &app, Arguments &a, const std::string &program)
  {
    if (app.got_subcommand("diff"))
      return diff(a.name, a.other);
    const Paths paths = find_paths(program, a.cases, a.solvers);
    if (app.got_subcommand("list"))
      return list(paths);
    if (app.got_subcommand("plan"))
      return plan(paths, a.campaign.cases, a.suite.empty() ? "quick" : a.suite);
    if (app.got_subcommand("report"))
      return report(paths, a.name);
    if (app.got_subcommand("figures"))
      return figures(paths, a.output.empty() ? "results/full" : a.output);
    if (app.got_subcommand("presets"))
      return presets(paths, {a.output.empty() ? "results/full" : a.output, a.readme});
    if (app.got_subcommand("modules"))
      return modules(paths, {a.output.empty() ? "results/quick" : a.output, a.readme});
    if (app.got_subcommand("advise"))
      return advise(paths,
                    {a.name, a.quantity, a.error, a.output.empty() ? "results/full" : a.output});
    if (app.got_subcommand("tradeoff") ||
        (app.got_subcommand("stability") && !app.get_subcommand("stability")->count("--suite")))
      a.campaign.suite = "full";
    a.campaign.output = a.output.empty() ? "results/" + a.campaign.suite : a.output;
    if (a.campaign.cores <= 0)
      a.campaign.cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (app.got_subcommand("tradeoff"))
      return trade_all(paths, a.campaign);
    if (app.got_subcommand("stability"))
      return stability(paths, a.campaign);
    return run(paths, a.campaign);
  }

  int no_such_command(const CLI::App &app, const std::string &written)
  {
    std::vector<std::string> commands;
    for (const auto *command : app.get_subcommands(nullptr))
      commands.push_back(command->get_name());
    std::sort(commands.begin(), commands.end());
    const std::string nearest = scene::nearest_name(written, commands);
    fmt::print(stderr, "verify: no such command: `{}`{}; there are: {}\n", written,
               nearest.empty() ? "" : fmt::format(" (did you mean `{}`?)", nearest),
               fmt::join(commands, ", "));
    return record::bad_input;
  }
} // namespace

int main(int argc, char **argv)
{
  // Threads that spin at a barrier while others hold the cores turn seconds into minutes; runs side
  // by side share cores. The solvers inherit this, unless the caller has chosen.
  setenv("OMP_WAIT_POLICY", "passive", 0);
  CLI::App app(
      "Runs the cases of benchmarks/, compares the records with their references, reports.\n"
      "Exit codes: 0 all right, 1 a comparison failed, 2 bad input, 3 numerical trouble or out of "
      "time,\n"
      "4 reference missing, 5 drift only, 6 a file could not be written, 130 interrupted.",
      "verify");
  Arguments arguments;
  app.add_option("--cases", arguments.cases, "folder of the case folders (default: benchmarks)");
  app.add_option("--solvers", arguments.solvers, "folder of the solvers (default: beside verify)");
  app.require_subcommand(1);
  app.fallthrough();
  add_run(app, arguments);
  add_others(app, arguments);
  add_trade(app, arguments);
  add_presets(app, arguments);
  try
  {
    app.parse(argc, argv);
    catch_interrupts();
    return dispatch(app, arguments, argv[0]);
  }
  catch (const CLI::ParseError &error)
  {
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty())
      return no_such_command(app, argv[1]);
    return app.exit(error) == 0 ? record::all_right
                                : record::bad_input; // CLI11's own codes start at 100
  }
  catch (const BadInput &error)
  {
    fmt::print(stderr, "{}\n", error.what());
    return record::bad_input;
  }
  catch (const std::filesystem::filesystem_error &error)
  {
    fmt::print(stderr, "verify: {}: {}; choose a folder that can be read and written\n",
               error.path1().string(), error.code().message());
    return error.code() == std::errc::no_space_on_device ? record::not_written : record::bad_input;
  }
  catch (const std::exception &error)
  {
    fmt::print(stderr, "verify: {}\n", error.what());
    return record::numerical_trouble;
  }
}
