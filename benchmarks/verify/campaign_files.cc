#include "campaign_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "record/atomic_write.h"
#include "record/provenance.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    constexpr std::size_t most_samples = 400;

    /// To six digits. std::stod would refuse the denormal numbers of a field that dies away.
    double rounded(const double value)
    {
      return std::isfinite(value) ? std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr)
                                  : value;
    }

    Json thinned(const std::vector<double> &values)
    {
      Json list = Json::array();
      const std::size_t n = values.size(), m = std::min(n, most_samples);
      for (std::size_t k = 0; k < m; ++k)
        list.push_back(rounded(values[m == n ? k : k * (n - 1) / (m - 1)]));
      return list;
    }

    Json to_json(const Curve &curve)
    {
      return {{"x", thinned(curve.x)}, {"y", thinned(curve.y)}};
    }

    Json to_json(const Outline &outline)
    {
      Json lines = Json::array();
      for (const auto &polyline : outline)
      {
        std::vector<double> x, y;
        for (const auto &p : polyline)
        {
          x.push_back(p[0]);
          y.push_back(p[1]);
        }
        lines.push_back({{"x", thinned(x)}, {"y", thinned(y)}});
      }
      return lines;
    }

    Json reference_runs(const Verdict &verdict)
    {
      Json runs = Json::array();
      for (const auto &name : verdict.check.order_over)
        runs.push_back(name);
      if (runs.empty())
        runs.push_back(verdict.check.take.run);
      return runs;
    }

    /// What the record tells of its own run; an unreadable record tells nothing.
    void add_record(const std::string &path, Json &run)
    {
      if (!fs::exists(path))
        return;
      try
      {
        const record::Reader reader(path);
        for (const char *key : {"steps", "cells", "points"})
          run[key] = number_or_null(reader.number(key));
        for (const auto &[name, value] : reader.profile().numbers)
          run["profile"][name] = number_or_null(value);
        for (const auto &part : reader.profile().parts)
          run["parts"][part.name] = {{"wall_s", rounded(part.wall_s)},
                                     {"cpu_s", rounded(part.cpu_s)},
                                     {"calls", part.calls}};
        for (const auto &[name, value] : reader.provenance())
          run["provenance"][name] = value;
        for (const char *key : {"inertia", "warning"}) // what the run says of itself
          if (const std::string said = reader.attribute(key); !said.empty())
            run[key] = said;
        run["build_type"] = reader.attribute("build_type");
        run["record_status"] = reader.status();
        run["scene_hash"] = reader.attribute("scene_hash");
      }
      catch (const std::exception &error)
      {
        run["record_status"] = error.what();
      }
    }

    Json case_to_json(const CaseResult &result, const Campaign &campaign, const Paths &paths)
    {
      const std::string repeat = repeat_case(paths, result.c, campaign.options.output);
      Json json{{"case", result.c.name},   {"title", result.c.title}, {"about", result.c.about},
                {"suite", result.c.suite}, {"scene", result.c.scene}, {"repeat", repeat}};
      json["checks"] = Json::array();
      for (const auto &verdict : result.verdicts)
        json["checks"].push_back(to_json(verdict, repeat));
      json["runs"] = Json::array();
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
      {
        Json run = run_to_json(result.c.runs[i], result.jobs[i], result.outcomes[i]);
        if (i < result.forecasts.size())
          add_forecast(result.forecasts[i], run);
        json["runs"].push_back(run);
      }
      std::vector<CaseResult> alone{result};
      json["exit_code"] = exit_code(alone);
      return json;
    }
  } // namespace

  Json number_or_null(const std::optional<double> &value)
  {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
  }

  std::string value_unit(const Check &check)
  {
    return !check.order_over.empty() || check.norm.rfind("relative", 0) == 0 ? "-" : check.unit;
  }

  std::string limit_text(const Check &check)
  {
    const bool interval = check.low != 0. || check.norm == "value" || !check.order_over.empty();
    return interval ? fmt::format("{:.4g} .. {:.4g}", check.low, check.high)
                    : fmt::format("{:.4g}", check.high);
  }

  Json to_json(const Verdict &v, const std::string &repeat)
  {
    Json json{{"name", v.check.name},
              {"take", describe(v.check.take)},
              {"against", describe(v.check.against)},
              {"norm", v.check.norm},
              {"value", number_or_null(v.value)},
              {"limit", {v.check.low, v.check.high}},
              {"unit", v.check.unit},
              {"value_unit", value_unit(v.check)},
              {"uncertainty", number_or_null(v.uncertainty)},
              {"uncertainty_text", v.uncertainty_text},
              {"status", text(v.status)},
              {"why", v.why},
              {"source", v.check.source},
              {"reason", v.check.reason},
              {"runs", reference_runs(v)},
              {"taken", number_or_null(v.taken)},
              {"reference", number_or_null(v.reference)}};
    json["drift"] = {{"accepted", number_or_null(v.drift.accepted)},
                     {"tolerance", v.drift.tolerance},
                     {"status", v.drift.unknown     ? "no accepted value"
                                : !v.drift.accepted ? "none"
                                : v.drift.drifted   ? "drift"
                                                    : "same"}};
    if (!v.h.empty())
      json["order"] = {{"h", v.h}, {"error", v.errors}};
    if (v.status != Status::pass)
      json["repeat"] = repeat;
    return json;
  }

  Json run_to_json(const Run &run, const Job &job, const Outcome &outcome)
  {
    Json json{{"name", run.name},
              {"solver", run.solver},
              {"scene", run.scene},
              {"set", run.set},
              {"status", outcome.status},
              {"exit_code", outcome.exit_code},
              {"expect_exit", run.expect_exit},
              {"wall_s", outcome.wall_s},
              {"cpu_s", outcome.cpu_s},
              {"peak_rss_bytes", outcome.peak_rss_bytes},
              {"steps", nullptr},
              {"cells", nullptr},
              {"points", nullptr},
              {"build_type", ""},
              {"reused", outcome.reused},
              {"record", job.base + ".h5"},
              {"log", job.command.log},
              {"hash", job.hash},
              {"repeat", shell(job.command.arguments)}};
    if (!outcome.log_tail.empty())
      json["last_words"] = outcome.log_tail;
    if (outcome.status == "complete")
      add_record(job.base + ".h5", json);
    return json;
  }

  Json curves_to_json(const Verdict &v)
  {
    Json json{{"check", v.check.name},
              {"taken", {{"label", describe(v.check.take)}}},
              {"reference", {{"label", describe(v.check.against)}}}};
    if (v.taken_curve)
      json["taken"].update(to_json(*v.taken_curve));
    if (v.reference_curve)
      json["reference"].update(to_json(*v.reference_curve));
    if (!v.taken_outline.empty())
      json["taken"]["outline"] = to_json(v.taken_outline);
    if (!v.reference_outline.empty())
      json["reference"]["outline"] = to_json(v.reference_outline);
    return json;
  }

  record::Lock lock_output(const std::string &folder)
  {
    fs::create_directories(folder);
    try
    {
      return record::Lock(folder + "/verify.lock", folder,
                          "wait for its end or stop it, or choose another --output");
    }
    catch (const std::runtime_error &error)
    {
      throw BadInput(error.what());
    }
  }

  void write_text(const std::string &path, const std::string &text)
  {
    fs::create_directories(fs::path(path).parent_path());
    record::write_atomically(path, text);
  }

  namespace
  {
    /// How many forecasts were met, by what was predicted.
    Json forecast_sums(const Json &cases)
    {
      Json sums;
      for (const char *what : {"time", "memory", "resident", "contact"})
      {
        sums[what] = {{"met", 0}, {"missed", 0}, {"not judged", 0}};
        for (const auto &one : cases)
          for (const auto &run : one["runs"])
            if (run.contains("forecast") && run["forecast"].contains(what))
            {
              auto &count = sums[what][run["forecast"][what].get<std::string>()];
              count = count.get<int>() + 1;
            }
      }
      return sums;
    }
  } // namespace

  void write_campaign(const Campaign &campaign, const Paths &paths)
  {
    const std::string &output = campaign.options.output;
    Json json{{"format", "mpm_pf campaign 1"},   {"suite", campaign.options.suite},
              {"started", campaign.started},     {"wall_s", campaign.wall_s},
              {"exit_code", campaign.exit_code}, {"cores", std::thread::hardware_concurrency()},
              {"jobs", campaign.options.cores}};
    for (const auto &[name, value] : record::collect_provenance(
             "verify", shell({paths.program, "run"}), campaign.options.cores))
      json["provenance"][name] = value;
    json["cases"] = Json::array();
    for (const auto &result : campaign.cases)
    {
      const Json verdict = case_to_json(result, campaign, paths);
      write_text(output + "/" + result.c.name + "/verdict.json", json_text(verdict));
      Json curves = Json::array();
      for (const auto &v : result.verdicts)
        curves.push_back(curves_to_json(v));
      write_text(output + "/" + result.c.name + "/curves.json", json_text(curves, true));
      json["cases"].push_back(verdict);
    }
    json["forecasts"] = forecast_sums(json["cases"]);
    write_text(output + "/campaign.json", json_text(json));
    write_text(output + "/junit.xml", junit(campaign, paths));
  }
} // namespace verify
