// verify tradeoff: error against cost for every set of settings that a case declares.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "campaign_files.h"
#include "commands.h"
#include "record/command_line.h"
#include "record/provenance.h"
#include "section.h"
#include "trade_default.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    constexpr double short_run_s = 1.; // below it one run says little: one warm-up, median of three
    constexpr int repetitions = 3;
    const std::string bad_input = "bad input"; // status of a run whose solver refused its settings
    const std::string not_written = "not written"; // and of one that found no room for its record

    struct Cost
    {
      double cpu_s = 0., wall_s = 0., spread_s = 0.;
    };

    double median(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      return values[values.size() / 2];
    }

    /// Costs of all jobs; short ones from `first` on are repeated, their first run counts as the
    /// warm-up.
    std::vector<Cost> costs_of(const std::vector<Job> &jobs, const std::vector<Outcome> &outcomes,
                               const std::size_t first, const JobOptions &options)
    {
      std::vector<Job> again;
      std::vector<std::size_t> whose;
      for (std::size_t i = first; i < jobs.size(); ++i)
        if (outcomes[i].good() && outcomes[i].cpu_s < short_run_s)
          for (int k = 1; k <= repetitions; ++k)
          {
            Job job = jobs[i];
            const std::string suffix = fmt::format("_again{}", k);
            for (auto &argument : job.command.arguments)
              if (argument == job.record_name())
                argument += suffix;
            job.name += suffix;
            job.base += suffix;
            job.command.log = job.base + ".log";
            job.keep_record = false;
            again.push_back(job);
            whose.push_back(i);
          }
      const auto repeated = run_jobs(again, options);
      std::vector<Cost> costs;
      for (std::size_t i = 0; i < jobs.size(); ++i)
      {
        std::vector<double> cpu, wall;
        for (std::size_t k = 0; k < whose.size(); ++k)
          if (whose[k] == i && repeated[k].good())
          {
            cpu.push_back(repeated[k].cpu_s);
            wall.push_back(repeated[k].wall_s);
          }
        if (cpu.empty())
          costs.push_back({outcomes[i].cpu_s, outcomes[i].wall_s, 0.});
        else
          costs.push_back({median(cpu), median(wall),
                           *std::max_element(cpu.begin(), cpu.end()) -
                               *std::min_element(cpu.begin(), cpu.end())});
      }
      return costs;
    }

    const Run *reference_of(const Trade &trade, const Check &check)
    {
      return check.against.kind == Against::Kind::run ? trade.c.find_run(check.against.take.run)
                                                      : nullptr;
    }

    /// What the errors of a measure are distances from.
    std::string against_what(const Trade &trade, const Check &check)
    {
      if (const Run *run = reference_of(trade, check))
        return run->solver == "fe_reference" ? "finite elements" : "mpm_pf, finer";
      return check.against.kind == Against::Kind::run   ? "itself"
             : check.against.kind == Against::Kind::csv ? "a table"
                                                        : "theory";
    }

    /// Finite elements held against finite elements of unknown error measure nothing.
    bool against_its_like(const Trade &trade, const Check &check, const Run &run)
    {
      const Run *reference = reference_of(trade, check);
      return reference && reference->solver == "fe_reference" && run.solver == "fe_reference" &&
             check.uncertain_against.empty();
    }

    /// Errors of one row in every measure; `uncertainty` gets the reference's own, once known.
    Json errors_of(const Trade &trade, const TradeRow &row, Records &records, Json &uncertainty,
                   Json &why)
    {
      Json errors;
      for (Check check : trade.measures)
      {
        if (against_its_like(trade, check, row.run))
        {
          errors[check.name] = nullptr;
          why.push_back(check.name + ": finite elements against finite elements of unknown error");
          continue;
        }
        const auto of_elements = trade.takes_of_elements.find(check.name);
        if (row.run.solver == "fe_reference" && of_elements != trade.takes_of_elements.end())
          check.take = of_elements->second;
        check.take.run = row.run.name;
        for (auto &inner : check.take.with)
          inner.run = row.run.name;
        if (check.against.kind == Against::Kind::run && check.against.take.run.empty())
          check.against.take.run = row.run.name;
        const Verdict verdict = judge(check, trade.c, records);
        errors[check.name] = number_or_null(verdict.value);
        if (!verdict.value)
          why.push_back(verdict.why);
        if (verdict.uncertainty)
          uncertainty[check.name] = *verdict.uncertainty;
      }
      return errors;
    }

    Json row_to_json(const TradeRow &row, const Job &job, const Outcome &outcome, const Cost &cost)
    {
      Json json{{"family", row.family},
                {"solver", row.run.solver},
                {"settings", Json::object()},
                {"set", row.run.set},
                {"status", outcome.status},
                {"exit_code", outcome.exit_code},
                {"cpu_s", cost.cpu_s},
                {"cpu_spread_s", cost.spread_s},
                {"wall_s", cost.wall_s},
                {"peak_rss_bytes", outcome.peak_rss_bytes},
                {"repeat", shell(job.command.arguments)}};
      for (const auto &setting : row.settings)
        json["settings"][setting.key] = setting.value;
      return json;
    }

    Json measure_rows(const Trade &trade, const std::vector<Job> &jobs,
                      const std::vector<Outcome> &outcomes, const std::vector<Cost> &costs,
                      const std::string &folder)
    {
      const std::size_t first = trade.references.size();
      std::map<std::string, std::string> unusable;
      for (std::size_t i = 0; i < outcomes.size(); ++i)
        if (!outcomes[i].good())
          unusable[trade.c.runs[i].name] = outcomes[i].status;
      Records records(folder, unusable);
      Json result{{"reference", {{"text", trade.reference_text}, {"uncertainty", Json::object()}}},
                  {"measures", Json::array()},
                  {"rows", Json::array()}};
      for (const auto &check : trade.measures)
      {
        result["measures"].push_back(check.name);
        result["reference"]["against"][check.name] = against_what(trade, check);
        if (reference_of(trade, check)) // unknown, unless its grids tell
          result["reference"]["uncertainty"][check.name] = nullptr;
      }
      for (std::size_t i = 0; i < first; ++i)
        result["reference"]["runs"].push_back(run_to_json(trade.c.runs[i], jobs[i], outcomes[i]));
      for (std::size_t r = 0; r < trade.rows.size(); ++r)
      {
        const std::size_t i = first + r;
        Json row = row_to_json(trade.rows[r], jobs[i], outcomes[i], costs[i]);
        row["why"] = Json::array();
        if (outcomes[i].status == bad_input || outcomes[i].status == not_written)
          row["why"].push_back(outcomes[i].log_tail);
        row["errors"] = errors_of(trade, trade.rows[r], records, result["reference"]["uncertainty"],
                                  row["why"]);
        result["rows"].push_back(row);
      }
      return result;
    }

    void print_rows(const Json &result)
    {
      for (const auto &row : result["rows"])
      {
        std::string settings, errors;
        for (const auto &[key, value] : row["settings"].items())
          settings += fmt::format("{}={} ", key, value.get<std::string>());
        for (const auto &[name, value] : row["errors"].items())
          errors += value.is_null() ? "  -" : fmt::format("  {:.3g}", value.get<double>());
        fmt::print("{:24} {:50} {:10} {:8.3f} s CPU{}\n", row["family"].get<std::string>(),
                   settings, row["status"].get<std::string>(), row["cpu_s"].get<double>(), errors);
      }
    }

    /// 6 if a run could not write; 2 if a row was refused, for nobody wants to trade what does not
    /// exist; 1 if there is a measure in which no row has an error.
    int usable(const Json &result)
    {
      int code = 0;
      for (const auto &row : result["rows"])
        if (row["status"] == bad_input)
        {
          fmt::print("a row of `{}` was refused:\n{}\n", row["family"].get<std::string>(),
                     row["why"].front().get<std::string>());
          code = std::max(code, 2);
        }
        else if (row["status"] == not_written)
        {
          fmt::print("a row of `{}` could not be written:\n{}\n", row["family"].get<std::string>(),
                     row["why"].front().get<std::string>());
          code = record::not_written;
        }
      for (const std::string measure : result["measures"])
      {
        const auto &rows = result["rows"];
        if (std::any_of(rows.begin(), rows.end(),
                        [&](const Json &row) { return row["errors"][measure].is_number(); }))
          continue;
        fmt::print("no row has an error in `{}`:\n", measure);
        std::set<std::string> causes; // each once: most rows miss the same
        for (const auto &row : rows)
          for (const std::string why : row["why"])
            causes.insert(why);
        for (const auto &row : rows)
          if (row["why"].empty())
            causes.insert(fmt::format("{}: {}", row["family"].get<std::string>(),
                                      row["status"].get<std::string>()));
        for (const auto &cause : causes)
          fmt::print("  {}\n", cause);
        code = std::max(code, 1);
      }
      return code;
    }
  } // namespace

  int tradeoff(const Paths &paths, const std::string &name, const CampaignOptions &options)
  {
    const std::string folder = case_folder(paths, name);
    const Trade trade =
        fs::exists(folder + "/tradeoff.toml") ? read_trade(folder) : default_trade(folder);
    const record::Lock lock = lock_output(options.output);
    const std::string runs = options.output + "/tradeoff/runs";
    auto jobs = jobs_of(trade.c, paths, runs);
    for (auto &job : jobs)
      job.any_exit = true;
    const JobOptions how{options.cores, options.fresh};
    const auto outcomes = run_jobs(jobs, how);
    const auto costs = costs_of(jobs, outcomes, trade.references.size(), how);
    if (interrupted())
      return record::interrupted;
    Json result{{"format", "mpm_pf tradeoff 1"}, {"case", name}, {"suite", trade.c.suite}};
    for (const auto &[key, value] : record::collect_provenance(
             "verify", shell({paths.program, "tradeoff", name}), options.cores))
      result["provenance"][key] = value;
    result.update(measure_rows(trade, jobs, outcomes, costs,
                               runs + "/" + name + "/" + scene_stem(trade.c.suite)));
    const std::string file = options.output + "/tradeoff/" + name + ".json";
    write_text(file, json_text(result));
    print_rows(result);
    fmt::print("{} rows in {}\n", trade.rows.size(), file);
    report(paths, options.output);
    for (std::size_t i = 0; i < trade.references.size(); ++i)
      if (!outcomes[i].good())
        return record::reference_missing;
    return usable(result);
  }
} // namespace verify
