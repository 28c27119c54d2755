#include "stability_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cannot_fail.h"
#include "expect_formulas.h"
#include "expect_take.h"
#include "run_ranges.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    std::string without_quotes(const std::string &literal)
    {
      const bool quoted = literal.size() > 1 && literal.front() == '"' && literal.back() == '"';
      return quoted ? literal.substr(1, literal.size() - 2) : literal;
    }

    Axis read_axis(Section &map, const std::string &key)
    {
      Axis axis;
      auto section = map.section(key);
      if (!section)
        return axis;
      const std::string name = section->text("key");
      axis.set = section->texts("set");
      if (!name.empty())
        axis.set.push_back(name + "={value}");
      if (axis.set.empty())
        section->add_error("", "an axis needs `key`, or `set` with {value} in it");
      axis.label = section->text("label", name);
      axis.values = section->literals("values");
      if (axis.values.empty())
        section->add_error("", "an axis needs `values`");
      for (auto &value : axis.values)
        if (without_quotes(value) == absent_value)
          value = absent_value;
      axis.absent = section->number("absent");
      axis.logarithmic = section->text("spacing", "linear") == "logarithmic";
      section->refuse_unused();
      return axis;
    }

    /// What stands for the values of a cell while formulas are looked through; each cell has its
    /// own.
    Constants with_axes(Constants constants)
    {
      for (const std::string axis : {"axis_x", "axis_y"})
      {
        constants.emplace_back(axis, 0.);
        for (int k = 0; k < 10; ++k)
          constants.emplace_back(axis + std::to_string(k), 0.);
      }
      return constants;
    }

    Accurate read_accurate(Section &section, const Case &c, const std::vector<std::string> &maps)
    {
      Accurate accurate;
      Check &check = accurate.check;
      check.name = section.text("name", "accurate");
      check.norm = section.required_text("norm");
      check.scale = section.expression("scale").value_or("");
      check.coverage = section.number("coverage");
      if (auto take = section.section("take"))
        check.take = read_take(*take, nullptr);
      else
        section.add_error("", "no `take`");
      check.take.run = "cell";
      for (auto &inner : check.take.with)
        inner.run = "cell";
      check.against = read_against(section, check);
      check_norm(section, "norm", check);
      read_limit(section, check, c.constants);
      Case known = c;
      known.constants = with_axes(c.constants);
      check_formulas(section, check, known.constants);
      check_csv(section, check, known);
      refuse_what_cannot_fail(section, check, c.constants);
      hand_coverage_on(check);
      accurate.maps = section.texts("maps");
      for (const auto &name : accurate.maps)
        if (std::count(maps.begin(), maps.end(), name) == 0)
          section.add_error("maps", fmt::format("there is no map `{}`", name),
                            fmt::format("there are: {}", fmt::join(maps, ", ")));
      section.refuse_unused();
      return accurate;
    }

    EnergyWatch read_energy(Section &section, const Case &c)
    {
      EnergyWatch watch;
      watch.take.kind = Take::Kind::table;
      watch.take.run = "cell";
      watch.take.probes = {{"", section.required_text("table")}};
      watch.take.of = section.required_text("of");
      watch.growth = section.number("growth").value_or(10.);
      if (const auto limit = section.expression("limit"))
        watch.limit = value_of(section, "limit", *limit, c.constants);
      section.refuse_unused();
      return watch;
    }

    void read_theory(Section &section, Map &map)
    {
      if (section.is_section("theory"))
      {
        auto rows = *section.section("theory");
        for (const auto &word : rows.keys())
          map.theory[word] = rows.expression(word).value_or("");
      }
      else if (const auto theory = section.expression("theory"))
        map.theory[""] = *theory;
      const auto edge = section.expressions("edge");
      if (edge.empty())
        return;
      if (edge.size() != 2 || map.theory.empty())
        section.add_error("edge",
                          "`edge` is [low, high], what the edge of stability over `theory` "
                          "must lie between",
                          "give both numbers, and `theory`");
      else
        map.edge = std::array<double, 2>{value_of(section, "edge", edge[0], {}),
                                         value_of(section, "edge", edge[1], {})};
    }

    Map read_map(Section &section, const Case &c)
    {
      Map map;
      map.name = section.required_text("name");
      map.solver = section.text("solver", "mpm_pf");
      map.scene = section.text("scene", c.scene);
      if (!fs::exists(fs::path(c.folder) / map.scene))
        section.add_error("scene", fmt::format("there is no {} in the case folder", map.scene));
      map.set = section.texts("set");
      map.x = read_axis(section, "x");
      map.y = read_axis(section, "y");
      if (map.x.values.empty())
        section.add_error("", "a map needs its axis `x`");
      map.bisections = static_cast<int>(section.number("bisections").value_or(0));
      read_theory(section, map);
      map.time_limit_s = time_limit_of(section, 60.);
      return map;
    }
  } // namespace

  const std::string absent_value = "absent";

  std::vector<std::string> Map::rows() const
  {
    return y.values.empty() ? std::vector<std::string>{""} : y.values;
  }

  Stability read_stability(const std::string &folder, const std::string &suite)
  {
    Section file(folder + "/stability.toml", suite);
    Stability stability;
    Case &c = stability.c;
    c.folder = folder;
    c.name = fs::path(folder).filename().string();
    c.suite = suite;
    c.scene = file.text("scene", takes_part(folder, "quick") ? "quick.toml" : "scene.toml");
    read_constants(file, c.constants);
    if (auto energy = file.section("energy"))
      stability.energy = read_energy(*energy, c);
    std::vector<std::string> names; // of all maps, those of other suites included
    for (auto &section : file.sections("map"))
    {
      names.push_back(section.required_text("name"));
      const auto suites = section.texts("suites");
      if (suites.empty() || std::find(suites.begin(), suites.end(), suite) != suites.end())
      {
        stability.maps.push_back(read_map(section, c));
        section.refuse_unused();
      }
    }
    for (auto &section : file.sections("accurate"))
      stability.accurate.push_back(read_accurate(section, c, names));
    file.refuse_unused();
    file.throw_errors();
    return stability;
  }
} // namespace verify
