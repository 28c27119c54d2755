#include "trade_default.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "paths.h"
#include "scene/reader.h"
#include "section.h"

namespace verify
{
  namespace
  {
    constexpr double time_limit_s = 60.;

    std::string suite_of(const std::string &folder)
    {
      for (const char *suite : {"quick", "smoke"})
        if (takes_part(folder, suite))
          return suite;
      return "full";
    }

    const Run *run_named(const Case &c, const std::string &name)
    {
      for (const Run &run : c.runs)
        if (run.name == name)
          return &run;
      return nullptr;
    }

    /// The run of a solver on the case's own scene that is meant to succeed: the scene as it
    /// stands, or else the first.
    const Run *base_run(const Case &c, const std::string &solver)
    {
      const Run *found = nullptr;
      for (const Run &run : c.runs)
        if (run.solver == solver && run.scene == c.scene && run.expect_exit == 0 &&
            run.needs.empty() && (!found || (!found->set.empty() && run.set.empty())))
          found = &run;
      return found;
    }

    bool of_one_run(const Take &take, const std::string &run)
    {
      return take.run == run || (take.kind == Take::Kind::value && !take.with.empty() &&
                                 std::all_of(take.with.begin(), take.with.end(),
                                             [&](const Take &inner) { return inner.run == run; }));
    }

    /// A number that should be nothing, by its limit; what a run cost is none of these.
    bool should_vanish(const Check &check)
    {
      return check.norm == "value" && check.low == 0. && check.high > 0. &&
             check.take.kind != Take::Kind::number;
    }

    /// Whether the check tells how wrong one run is: against theory, finite elements, or another
    /// quantity of the run itself.
    bool measures_error(const Check &check, const Case &c, const Run &base)
    {
      const bool of_base =
          !check.order_over.empty()
              ? std::count(check.order_over.begin(), check.order_over.end(), base.name) > 0
              : of_one_run(check.take, base.name);
      if (!of_base || (check.norm == "value" && !should_vanish(check)))
        return false;
      if (check.against.kind != Against::Kind::run)
        return true;
      if (!check.against.take.with.empty())
        return false;
      const Run *other = run_named(c, check.against.take.run);
      return other && (other->name == base.name || other->solver == "fe_reference");
    }

    struct Family
    {
      std::string name, key;
      std::vector<std::string> values;
      std::vector<std::string> set;
    };

    /// The scene's cells times 1/2, 1 and 2, as far as they are whole.
    std::vector<std::string> scaled(const std::array<int, 2> &cells)
    {
      std::vector<std::string> values;
      if (cells[0] % 2 == 0 && cells[1] % 2 == 0)
        values.push_back(fmt::format("[{},{}]", cells[0] / 2, cells[1] / 2));
      values.push_back(fmt::format("[{},{}]", cells[0], cells[1]));
      values.push_back(fmt::format("[{},{}]", 2 * cells[0], 2 * cells[1]));
      return values;
    }

    const std::vector<std::string> levels{"\"draft\"", "\"standard\"", "\"fine\""};

    /// What a preset chooses must not be the scene's own word. A Mach number stays: whether inertia
    /// may be scaled is what a case is about, not how well it is resolved.
    std::vector<std::string> left_to_the_preset()
    {
      return {"domain.cells=",
              "mpm.points_per_cell=",
              "growth.precision=",
              "advection.scheme=",
              "advection.step_fraction=",
              "fe.cells=",
              "fe.degree=",
              "fe.load_steps="};
    }

    std::vector<Family> families_of(const scene::Scene &s)
    {
      std::vector<Family> families{{"cells", "domain.cells", scaled(s.domain.cells), {}}};
      if (s.solid)
      {
        families.push_back({"points per cell", "mpm.points_per_cell", {"[2,2]", "[3,3]"}, {}});
        families.push_back({"step", "mpm.step_fraction", {"0.2", "0.7"}, {}});
        families.push_back(
            {"shape function", "mpm.shape_function", {"\"ugimp\"", "\"linear\""}, {}});
        families.push_back({"transfer", "mpm.transfer", {"\"apic\"", "\"flip\""}, {}});
      }
      if (s.growth)
      {
        families.push_back({"precision", "growth.precision", {"\"float\""}, {}});
        families.push_back({"Laplacian", "growth.laplacian", {"\"five_point\""}, {}});
      }
      if (s.imposed || (s.solid && s.phase_field))
        families.push_back({"advection",
                            "advection.scheme",
                            {"\"cip\"", "\"cip_hermite\"", "\"weno5\"", "\"upwind\""},
                            {}});
      families.push_back({"accuracy presets", "accuracy", levels, left_to_the_preset()});
      return families;
    }

    std::vector<Family> element_families(const scene::Scene &s)
    {
      const scene::Fe fe = s.fe.value_or(scene::Fe{});
      std::vector<Family> families{
          {"finite elements, load steps",
           "fe.load_steps",
           {std::to_string(std::max(1, fe.load_steps / 4)), std::to_string(fe.load_steps)},
           {}}};
      if (fe.cells[0] > 0)
        families.push_back({"finite elements, cells", "fe.cells", scaled(fe.cells), {}});
      families.push_back(
          {"accuracy presets, finite elements", "accuracy", levels, left_to_the_preset()});
      return families;
    }

    void add_rows(Trade &trade, const Run &base, const std::vector<Family> &families)
    {
      for (const Family &family : families)
        for (const std::string &value : family.values)
        {
          TradeRow row{family.name, {{family.key, value}}, base};
          row.run.name = fmt::format("default_{}", trade.rows.size() + 1);
          row.run.time_limit_s = time_limit_s;
          row.run.set.insert(row.run.set.end(), family.set.begin(), family.set.end());
          row.run.set.push_back(family.key + "=" + value);
          trade.rows.push_back(row);
          trade.c.runs.push_back(row.run);
        }
    }

    void add_reference(Trade &trade, const Case &c, const std::string &name)
    {
      if (run_named(trade.c, name))
        return;
      trade.c.runs.push_back(*run_named(c, name));
      trade.references.push_back(name);
    }

    void add_measures(Trade &trade, const Case &c, const Run &base)
    {
      for (Check check : c.checks)
      {
        if (!measures_error(check, c, base))
          continue;
        if (check.norm == "value") // should vanish
        {
          check.norm = "absolute";
          check.against = Against{};
          check.against.kind = Against::Kind::zero;
        }
        if (!check.order_over.empty())
          check.name = fmt::format("error behind \"{}\"", check.name);
        check.order_over.clear();
        check.low = 0.;
        check.high = std::numeric_limits<double>::infinity();
        check.uncertain_take.clear();
        const bool of_itself = check.against.take.run == base.name;
        if (check.against.kind == Against::Kind::run && of_itself)
          check.against.take.run.clear(); // each row's own
        else if (check.against.kind == Against::Kind::run)
        {
          add_reference(trade, c, check.against.take.run);
          for (const auto &grid : check.uncertain_against)
            add_reference(trade, c, grid);
        }
        check.name += ", " + check.norm;
        trade.measures.push_back(check);
      }
    }
  } // namespace

  Trade default_trade(const std::string &folder)
  {
    const Case c = read_case(folder, suite_of(folder));
    Trade trade;
    trade.c = c;
    trade.c.runs.clear();
    const Run *base = base_run(c, "mpm_pf");
    if (base)
      add_measures(trade, c, *base);
    if (trade.measures.empty())
      throw BadInput(fmt::format("{} declares no trade (tradeoff.toml), and none of its checks "
                                 "holds one run against theory or finite elements",
                                 folder));
    const scene::Scene s = scene::read_scene(folder + "/" + base->scene, base->set);
    add_rows(trade, *base, families_of(s));
    if (const Run *elements = base_run(c, "fe_reference"))
      add_rows(trade, *elements, element_families(s));
    trade.reference_text = "the checks of expect.toml";
    return trade;
  }
} // namespace verify
