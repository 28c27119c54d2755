#include "trade_file.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "cannot_fail.h"
#include "expect_formulas.h"
#include "expect_take.h"
#include "judge.h"
#include "run_ranges.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();

    Run base_run(Section &section, const Case &c, const double time_limit_s)
    {
      Run run;
      run.solver = section.text("solver", "mpm_pf");
      if (run.solver != "mpm_pf" && run.solver != "fe_reference")
        section.add_error("solver", "the solver is \"mpm_pf\" or \"fe_reference\"");
      run.scene = section.text("scene", c.scene);
      run.set = section.texts("set");
      run.time_limit_s = time_limit_of(section, time_limit_s);
      run.threads = static_cast<int>(section.number("threads").value_or(1));
      if (!fs::exists(fs::path(c.folder) / run.scene))
        section.add_error("scene", fmt::format("there is no {} in the case folder", run.scene));
      return run;
    }

    /// The references from fine to coarse; the finest is what the errors are measured against.
    void read_references(Section &file, Trade &trade, const double time_limit_s)
    {
      for (auto &section : file.sections("reference"))
      {
        Run run = base_run(section, trade.c, 5. * time_limit_s);
        run.h = section.number("h");
        if (!run.h)
          section.add_error("", "a reference needs its mesh size `h`");
        check_mesh_size(section, run);
        run.name = fmt::format("reference_{}", trade.c.runs.size() + 1);
        section.refuse_unused();
        trade.c.runs.push_back(run);
      }
      std::sort(trade.c.runs.begin(), trade.c.runs.end(),
                [](const Run &a, const Run &b) { return a.h < b.h; });
      std::vector<const Run *> grids;
      for (const auto &run : trade.c.runs)
      {
        trade.references.push_back(run.name);
        grids.push_back(&run);
      }
      refuse_equal_grids(file, "reference", grids);
    }

    void read_quantity(Section &section, Trade &trade)
    {
      Check check;
      const std::string name = section.required_text("name");
      check.unit = section.text("unit", "-");
      check.coverage = section.number("coverage");
      check.scale = section.expression("scale").value_or("");
      check.high = infinite;
      const auto norms = section.texts("norms");
      if (norms.empty())
        section.add_error("", "a quantity needs `norms`: the errors that are measured");
      if (auto take = section.section("take"))
        check.take = read_take(*take, nullptr);
      else
        section.add_error("", "the quantity has no `take`");
      check.norm = norms.empty() ? "relative" : norms.front();
      if (section.has("against"))
      {
        check.against = read_against(section, check);
        if (check.against.kind == Against::Kind::run && trade.references.size() >= 3 &&
            check.against.take.run == trade.references.front())
          check.uncertain_against = trade.references;
      }
      else if (trade.references.empty())
        section.add_error("", "the quantity has no `against`, and the file no [[reference]]");
      else
      {
        check.against.kind = Against::Kind::run;
        check.against.take = check.take;
        check.against.take.run = trade.references.front();
        if (trade.references.size() >= 3)
          check.uncertain_against = trade.references;
      }
      std::optional<Take> of_elements;
      if (auto take = section.section("take_fe_reference"))
      {
        Check other = check;
        other.take = read_take(*take, &check.take);
        check_formulas(section, other, trade.c.constants);
        hand_coverage_on(other);
        of_elements = other.take;
      }
      check_formulas(section, check, trade.c.constants);
      check_csv(section, check, trade.c);
      refuse_what_cannot_fail(section, check, trade.c.constants);
      hand_coverage_on(check);
      for (const auto &norm : norms)
      {
        check.norm = norm;
        check_norm(section, "norms", check);
        check.name = name + ", " + norm;
        trade.measures.push_back(check);
        if (of_elements)
          trade.takes_of_elements[check.name] = *of_elements;
      }
      section.refuse_unused();
    }

    /// All combinations of one value from each list.
    std::vector<std::vector<Setting>> product(Section &lists)
    {
      std::vector<std::vector<Setting>> combinations{{}};
      for (const auto &key : lists.keys())
      {
        std::vector<std::vector<Setting>> longer;
        for (const auto &combination : combinations)
          for (const auto &value : lists.literals(key))
          {
            longer.push_back(combination);
            longer.back().push_back({key, value});
          }
        combinations = longer;
      }
      return combinations;
    }

    void read_family(Section &section, Trade &trade, const std::size_t number,
                     const double time_limit_s)
    {
      const Run base = base_run(section, trade.c, time_limit_s);
      const std::string name = section.required_text("name");
      std::vector<std::vector<Setting>> combinations{{}};
      if (auto lists = section.section("lists"))
        combinations = product(*lists);
      std::size_t member = 0;
      for (const auto &settings : combinations)
      {
        TradeRow row{name, settings, base};
        row.run.name = fmt::format("family{}_{}", number, ++member);
        for (const auto &setting : settings)
          row.run.set.push_back(setting.key + "=" + setting.value);
        trade.rows.push_back(row);
        trade.c.runs.push_back(row.run);
      }
      section.refuse_unused();
    }

    std::string reference_text(const Trade &trade)
    {
      for (const auto &check : trade.measures)
        if (check.against.kind == Against::Kind::formula)
          return "theory: " + check.against.text;
      if (trade.references.empty())
        return trade.measures.empty() ? "" : describe(trade.measures.front().against);
      const Run &finest = trade.c.runs.front();
      std::string text = finest.solver;
      for (const auto &setting : finest.set)
        text += " " + setting;
      return text + (trade.references.size() >= 3 ? ", its uncertainty from its grids" : "");
    }
  } // namespace

  Trade read_trade(const std::string &folder)
  {
    const std::string path = folder + "/tradeoff.toml";
    if (!fs::exists(path))
      throw BadInput(fmt::format("{} is missing: this case declares no trade", path));
    Section file(path, "full");
    Trade trade;
    trade.c.folder = folder;
    trade.c.name = fs::path(folder).filename().string();
    trade.c.suite = file.text("suite", "quick");
    trade.c.scene = file.text("scene", scene_file(trade.c.suite));
    const double time_limit_s = time_limit_of(file, 60.);
    read_constants(file, trade.c.constants);
    read_references(file, trade, time_limit_s);
    for (auto &section : file.sections("quantity"))
      read_quantity(section, trade);
    std::size_t number = 0;
    for (auto &section : file.sections("family"))
      read_family(section, trade, ++number, time_limit_s);
    if (trade.measures.empty() || trade.rows.empty())
      file.add_error("", "a trade needs at least one [[quantity]] and one [[family]]");
    file.refuse_unused();
    file.throw_errors();
    trade.reference_text = reference_text(trade);
    return trade;
  }
} // namespace verify
