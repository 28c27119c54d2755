#include "expect.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cannot_fail.h"
#include "expect_formulas.h"
#include "expect_take.h"
#include "run_ranges.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;

  const std::array<const char *, 15> norms{"relative",
                                           "absolute",
                                           "relative_max",
                                           "max",
                                           "relative_rms",
                                           "rms",
                                           "relative_l2",
                                           "l2",
                                           "relative_mean",
                                           "mean",
                                           "symmetric_difference",
                                           "relative_symmetric_difference",
                                           "hausdorff",
                                           "rms_distance",
                                           "value"};

  const Run *Case::find_run(const std::string &wanted) const
  {
    for (const auto &run : runs)
      if (run.name == wanted)
        return &run;
    return nullptr;
  }

  std::string scene_stem(const std::string &suite)
  {
    return suite == "full" ? "scene" : suite;
  }
  std::string scene_file(const std::string &suite)
  {
    return scene_stem(suite) + ".toml";
  }

  bool takes_part(const std::string &folder, const std::string &suite)
  {
    return fs::exists(fs::path(folder) / scene_file(suite));
  }

  namespace
  {
    bool in_suite(Section &section, const std::string &suite, const std::string &folder)
    {
      const auto suites = section.texts("suites");
      bool ever = suites.empty();
      for (const auto &name : suites)
      {
        if (name != "smoke" && name != "quick" && name != "full")
          section.add_error("suites", "a suite is smoke, quick or full, not " + name);
        ever |= takes_part(folder, name);
      }
      if (!ever)
        section.add_error("suites",
                          fmt::format("the case takes part in none of {}: this would never be run",
                                      fmt::join(suites, ", ")),
                          "write the scene file of the suite (smoke.toml, quick.toml, scene.toml), "
                          "or name another suite");
      return suites.empty() || std::find(suites.begin(), suites.end(), suite) != suites.end();
    }

    // Of a value that a compiler changes tenfold, as round-off is, nothing can have drifted; more
    // would let everything pass.
    constexpr double largest_drift = 10.;

    double default_time_limit(const std::string &suite)
    {
      return suite == "smoke" ? 60. : suite == "quick" ? 300. : 1800.;
    }

    void check_output_pattern(Section &section, const std::string &pattern)
    {
      try
      {
        const std::regex compiled(pattern, std::regex::icase);
      }
      catch (const std::regex_error &)
      {
        section.add_error("expect_output", fmt::format("`{}` is no regular expression", pattern),
                          "a bracket, *, + or ? that means itself needs \\\\ before it");
      }
    }

    Run read_run(Section &section, const Case &c)
    {
      Run run;
      run.solver = section.required_text("solver");
      if (run.solver != "mpm_pf" && run.solver != "fe_reference")
        section.add_error("solver", "the solver is \"mpm_pf\" or \"fe_reference\"");
      run.name = section.text("name", run.solver);
      check_run_name(section, run.name);
      run.scene = section.text("scene", c.scene);
      if (!run.scene.empty() && !fs::exists(fs::path(c.folder) / run.scene))
        section.add_error("scene", fmt::format("there is no {} in the case folder", run.scene));
      run.set = section.texts("set");
      run.needs = section.texts("needs");
      run.h = section.number("h");
      check_mesh_size(section, run);
      run.threads = count_of(section, "threads");
      run.processes = count_of(section, "processes");
      run.time_limit_s = time_limit_of(section, default_time_limit(c.suite));
      run.expect_exit = static_cast<int>(section.number("expect_exit").value_or(0));
      run.expect_output = section.text("expect_output");
      check_output_pattern(section, run.expect_output);
      return run;
    }

    void read_uncertainty(Section &section, Check &check)
    {
      auto uncertainty = section.section("uncertainty");
      if (!uncertainty)
        return;
      check.uncertain_take = uncertainty->texts("take");
      check.uncertain_against = uncertainty->texts("against");
      check.order_at_most = uncertainty->number("order_at_most").value_or(2.);
      for (const auto &runs : {check.uncertain_take, check.uncertain_against})
        if (runs.size() == 1 || runs.size() == 2)
          section.add_error("uncertainty", "an uncertainty needs at least three grids");
      if (!check.uncertain_against.empty() && check.against.kind != Against::Kind::run)
        section.add_error("uncertainty",
                          "`against` names grids, and the check is held against no run",
                          "leave them out: a formula, a table or a number has no grids");
      uncertainty->refuse_unused();
    }

    Check read_check(Section &section, const Case &c)
    {
      Check check;
      check.name = section.required_text("name");
      check.norm = section.required_text("norm");
      check.source = section.required_text("source");
      check.reason = section.required_text("reason");
      check.unit = section.text("unit", "-");
      check.scale = section.expression("scale").value_or("");
      check.order_over = section.texts("order_over");
      check.coverage = section.number("coverage");
      check.drift = section.number("drift").value_or(0.02);
      if (!(check.drift >= 0. && check.drift <= largest_drift))
        section.add_error("drift", fmt::format("a drift of {} is none", check.drift),
                          fmt::format("from 0 to {}", largest_drift));
      if (check.order_over.size() == 1)
        section.add_error("order_over", "an order needs at least two runs");
      if (auto take = section.section("take"))
        check.take = read_take(*take, nullptr);
      else
        section.add_error("", "the check has no `take`");
      check.against = read_against(section, check);
      check_norm(section, "norm", check);
      read_uncertainty(section, check);
      read_limit(section, check, c.constants);
      check_formulas(section, check, c.constants);
      check_csv(section, check, c);
      refuse_what_cannot_fail(section, check, c.constants);
      hand_coverage_on(check);
      return check;
    }

    /// Every run that a check names must be one of this suite, with its h where that is needed.
    void check_names(Section &section, const Check &check, const Case &c)
    {
      std::set<std::string> graded(check.order_over.begin(), check.order_over.end());
      graded.insert(check.uncertain_take.begin(), check.uncertain_take.end());
      graded.insert(check.uncertain_against.begin(), check.uncertain_against.end());
      for (const auto &name : runs_of(check))
        if (!c.find_run(name))
          section.add_error("take", fmt::format("suite {} has no run `{}`", c.suite, name),
                            "list it as [[run]], or restrict the check with suites = [...]");
        else if (graded.count(name) && !c.find_run(name)->h)
          section.add_error("take", fmt::format("run `{}` needs its mesh size `h`", name));
      const auto refuse_equal = [&](const std::string &key, const std::vector<std::string> &names)
      {
        std::vector<const Run *> runs;
        for (const auto &name : names)
          runs.push_back(c.find_run(name));
        refuse_equal_grids(section, key, runs);
      };
      refuse_equal("order_over", check.order_over);
      refuse_equal("uncertainty", check.uncertain_take);
      refuse_equal("uncertainty", check.uncertain_against);
    }

    /// Runs that need each other would wait for ever.
    void refuse_circles(Section &file, const Case &c)
    {
      std::set<std::string> startable;
      for (std::size_t before = 1; before != startable.size();)
      {
        before = startable.size();
        for (const auto &run : c.runs)
          if (std::all_of(run.needs.begin(), run.needs.end(),
                          [&](const std::string &needed)
                          { return startable.count(needed) > 0 || !c.find_run(needed); }))
            startable.insert(run.name);
      }
      for (const auto &run : c.runs)
        if (startable.count(run.name) == 0)
          file.add_error(
              "run",
              fmt::format("run `{}` can never start: what it needs, {}, waits for itself", run.name,
                          fmt::join(run.needs, ", ")),
              "let `needs` name only runs that can be finished before");
    }

    void read_runs(Section &file, Case &c)
    {
      for (auto &section : file.sections("run"))
      {
        const bool here = in_suite(section, c.suite, c.folder);
        Run run = read_run(section, c);
        section.refuse_unused();
        if (here && c.find_run(run.name))
          section.add_error("name",
                            fmt::format("two runs of suite {} are called `{}`", c.suite, run.name));
        if (here)
          c.runs.push_back(run);
      }
      if (c.runs.empty())
        file.add_error("", fmt::format("no [[run]] for suite {}", c.suite));
      for (const auto &run : c.runs)
        for (const auto &needed : run.needs)
          if (!c.find_run(needed))
            file.add_error("run", fmt::format("run `{}` needs `{}`, which this suite does not have",
                                              run.name, needed));
      refuse_circles(file, c);
    }
  } // namespace

  Case read_case(const std::string &folder, const std::string &suite)
  {
    Case c;
    c.folder = folder;
    c.name = fs::path(folder).filename();
    c.suite = suite;
    c.scene = scene_file(suite);
    Section file((fs::path(folder) / "expect.toml").string(), suite);
    c.title = file.required_text("title");
    c.about = file.text("about");
    read_constants(file, c.constants);
    read_runs(file, c);
    std::set<std::string> names;
    for (auto &section : file.sections("check"))
    {
      const bool here = in_suite(section, suite, folder);
      if (!here)
        continue; // its by-suite values need not exist here
      const Check check = read_check(section, c);
      section.refuse_unused();
      check_names(section, check, c);
      if (!names.insert(check.name).second)
        section.add_error("name",
                          fmt::format("two checks of suite {} are called `{}`", suite, check.name));
      c.checks.push_back(check);
    }
    file.refuse_unused();
    file.throw_errors();
    return c;
  }
} // namespace verify
