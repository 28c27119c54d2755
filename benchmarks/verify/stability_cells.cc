#include "stability_cells.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include "curve.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    /// `name` is the value, and name0, name1, ... are the entries of a list, as far as they are
    /// numbers.
    void add_axis(Constants &constants, const std::string &name, const Axis &axis,
                  const std::string &value)
    {
      if (value == absent_value && axis.absent)
        constants.emplace_back(name, *axis.absent);
      const auto add = [&constants](const std::string &of, const std::string &text)
      {
        char *end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        if (!text.empty() && *end == '\0')
          constants.emplace_back(of, number);
      };
      add(name, value);
      int k = 0;
      for (const auto &entry : entries_of(value))
        add(name + std::to_string(k++), entry);
    }
  } // namespace

  std::string with_value(std::string setting, const std::string &value)
  {
    using boost::algorithm::replace_all; // goes on behind the word, which may hold the mark itself
    replace_all(setting, "{value}", value == absent_value ? "" : value);
    int k = 0;
    for (const auto &entry : entries_of(value))
      replace_all(setting, fmt::format("{{{}}}", k++), entry);
    return setting;
  }

  std::vector<std::string> entries_of(const std::string &value)
  {
    std::vector<std::string> entries;
    if (value.size() < 2 || value.front() != '[')
      return entries;
    std::stringstream inside(value.substr(1, value.size() - 2));
    for (std::string entry; std::getline(inside, entry, ',');)
      entries.push_back(entry.substr(std::min(entry.size(), entry.find_first_not_of(' '))));
    return entries;
  }

  Cell Mapper::cell(const Map &map, const std::size_t number, const std::string &x,
                    const std::string &y) const
  {
    Cell result;
    result.map = &map;
    result.x = x;
    result.y = y;
    Run run;
    run.solver = map.solver;
    run.scene = map.scene;
    run.set = map.set;
    for (const auto &setting : map.x.set)
      run.set.push_back(with_value(setting, x));
    for (const auto &setting : map.y.set)
      run.set.push_back(with_value(setting, y));
    run.time_limit_s = map.time_limit_s;
    run.name = fmt::format("map{}_{}", number, hash_of(x + "|" + y));
    result.name = run.name;
    result.job = job_of(run, stability.c, paths, runs);
    result.job.any_exit = true;
    return result;
  }

  void Mapper::run(std::vector<Cell> &cells) const
  {
    std::vector<Job> jobs;
    for (const auto &cell : cells)
      jobs.push_back(cell.job);
    const auto outcomes = run_jobs(jobs, {options.cores, options.fresh});
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      cells[i].outcome = outcomes[i];
      classify(cells[i]);
    }
  }

  void Mapper::classify(Cell &cell) const
  {
    const auto &outcome = cell.outcome;
    cell.why = outcome.log_tail.substr(0, 600);
    if (outcome.status == "bad input")
      cell.kind = "refused";
    else if (outcome.status == "timed out")
      cell.kind = "out of time";
    else if (outcome.status == "diverged")
      cell.kind = "diverged";
    else if (!outcome.good())
      cell.kind = "not judged";
    else
      classify_finished(cell);
  }

  void Mapper::classify_finished(Cell &cell) const
  {
    Case c = stability.c;
    Records records(fs::path(cell.job.base).parent_path().string(), {});
    try
    {
      if (stability.energy && energy_grows(cell, records))
        return;
    }
    catch (const MissingData &error)
    {
      cell.kind = "not judged";
      cell.why = error.what();
      return;
    }
    cell.kind = "not judged"; // unless something is asked of this map
    bool judged = false;
    add_axis(c.constants, "axis_x", cell.map->x, cell.x);
    add_axis(c.constants, "axis_y", cell.map->y, cell.y);
    for (const auto &accurate : stability.accurate)
    {
      if (!accurate.maps.empty() &&
          std::count(accurate.maps.begin(), accurate.maps.end(), cell.map->name) == 0)
        continue;
      Check check = accurate.check;
      if (!judged)
        cell.kind = "accurate";
      judged = true;
      check.take.run = cell.name;
      for (auto &inner : check.take.with)
        inner.run = cell.name;
      if (check.against.kind == Against::Kind::run)
        check.against.take.run = cell.name;
      const Verdict verdict = judge(check, c, records);
      if (verdict.status == Status::pass && cell.kind == "accurate")
        cell.why += fmt::format("{} {:.3g}; ", check.name, *verdict.value);
      // A fault that was found stays one; a reference that is not there judges nothing.
      else if (verdict.status != Status::pass && cell.kind != "bounded but wrong")
      {
        cell.kind = verdict.status == Status::fail ? "bounded but wrong" : "not judged";
        cell.why = check.name + ": " + verdict.why;
      }
    }
  }

  bool Mapper::energy_grows(Cell &cell, Records &records) const
  {
    const auto &watch = *stability.energy;
    const Quantity quantity = measure(watch.take, stability.c.constants, records, cell.name);
    const Curve &curve = std::get<Curve>(quantity);
    const double middle = 0.5 * (curve.t.front() + curve.t.back());
    const double early = reduce(between(curve, true, curve.t.front(), middle), "max_abs"),
                 late = reduce(between(curve, true, middle, curve.t.back()), "max_abs");
    const double limit = watch.limit.value_or(watch.growth * early);
    if (late <= limit)
      return false;
    cell.kind = "growing energy";
    cell.why = fmt::format("{:.3g} in the last half of the run, allowed {:.3g}", late, limit);
    return true;
  }

  std::vector<Cell> Mapper::grid(const Map &map, const std::size_t number) const
  {
    const auto rows = map.rows();
    std::vector<Cell> cells;
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (std::size_t i = 0; i < map.x.values.size(); ++i)
      {
        cells.push_back(cell(map, number, map.x.values[i], rows[j]));
        cells.back().column = i;
        cells.back().row = j;
      }
    return cells;
  }
} // namespace verify
