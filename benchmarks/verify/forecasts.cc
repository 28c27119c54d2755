#include "forecasts.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "campaign_files.h"

namespace verify
{
  namespace
  {
    constexpr double memory_tolerance = 0.10, resident_slack_bytes = 50e6;
    constexpr double small_memory_bytes = 1e6; // below it not judged: a page decides
    // Starting a program and opening its record is no part of the forecast and hardly repeats; of a
    // short run it is all.
    constexpr double start_s = 0.15, short_run_s = 1.;
    // On shared cores seconds say little: shown as met or missed, but not held against a run.
    constexpr double gated_run_s = 10.;

    double number_after(const std::string &line, const std::string &mark)
    {
      const auto at = line.find(mark);
      return at == std::string::npos ? std::nan("")
                                     : std::strtod(line.c_str() + at + mark.size(), nullptr);
    }

    std::string rest_after(const std::string &line, const std::string &mark)
    {
      return line.rfind(mark, 0) == 0 ? line.substr(mark.size()) : "";
    }

    /// Bytes of the solver as its record sums them; nothing if it does not.
    std::optional<double> measured_bytes(const Json &run)
    {
      double total = 0.;
      bool any = false;
      if (!run.contains("profile"))
        return {};
      for (const auto &[name, value] : run.at("profile").items())
        if (name.rfind("bytes ", 0) == 0 && value.is_number())
        {
          total += value.get<double>();
          any = true;
        }
      return any ? std::optional<double>(total) : std::nullopt;
    }

    /// What the run itself estimated in all once a wall had met its crystal; nothing if none did.
    std::optional<double> forecast_at_contact(const Json &run)
    {
      const Json profile = run.value("profile", Json());
      const auto found = profile.find("forecast_at_contact_cpu_s");
      return found != profile.end() && found->is_number()
                 ? std::optional<double>(found->get<double>())
                 : std::nullopt;
    }

    bool points_are_seeded(const Json &run)
    {
      return run.contains("profile") && run.at("profile").contains("growth_steps") &&
             run.at("profile").contains("points");
    }

    /// As a part of what is allowed.
    double time_miss(const double forecast_s, const double measured_s, const double factor)
    {
      return std::abs(std::log(forecast_s / measured_s)) / std::log(factor);
    }

    Verdict forecast_of(const std::string &name, const std::string &reason)
    {
      Verdict verdict;
      Check &check = verdict.check;
      check.name = "forecast, " + name;
      check.norm = "value";
      check.unit = "of what is allowed";
      check.source = "--plan of the same scene and settings, asked when the run was over";
      check.reason = reason;
      check.take.kind = Take::Kind::number;
      check.take.of = "forecast";
      check.high = 1.;
      return verdict;
    }
  } // namespace

  Job forecast_job(const Job &run)
  {
    Job job = run;
    job.name += " (plan)";
    job.base += ".plan";
    job.command.log = job.base + ".log";
    job.command.arguments.push_back("--plan");
    job.after.clear(); // what the run needs is there
    job.keep_record = job.makes_record = false;
    job.any_exit = true;
    job.hash = hash_of(run.hash + " plan");
    return job;
  }

  std::optional<Forecast> read_forecast(const std::string &log)
  {
    std::ifstream stream(log);
    Forecast forecast;
    bool found = false;
    for (std::string line; std::getline(stream, line);)
    {
      if (const auto on = rest_after(line, "  on: "); !on.empty())
        forecast.on = on;
      else if (line.rfind("fe_reference: ", 0) == 0)
        forecast.on = "solid";
      if (const auto off = rest_after(line, "  off: "); !off.empty())
        forecast.off = off;
      if (const auto memory = rest_after(line, "  memory, "); memory.find(": ") < memory.size())
        forecast.bytes[memory.substr(0, memory.find(": "))] = 1e6 * number_after(memory, ": ");
      if (line.rfind("forecast ", 0) != 0)
        continue;
      found = true;
      forecast.cpu_s = number_after(line, "cpu_s=");
      forecast.solver_bytes = number_after(line, "solver_bytes=");
      forecast.resident_bytes = number_after(line, "resident_bytes=");
    }
    forecast.bytes.erase("all modules");
    return found ? std::optional<Forecast>(forecast) : std::nullopt;
  }

  void add_forecast(const std::optional<Forecast> &forecast, Json &run)
  {
    if (!forecast || run.at("status") != "complete")
      return;
    const double cpu = run.at("cpu_s"), resident = run.at("peak_rss_bytes");
    const auto bytes = measured_bytes(run);
    const double factor = run.at("solver") == "fe_reference" || points_are_seeded(run) ? 3. : 2.;
    Json json{{"on", forecast->on},
              {"off", forecast->off},
              {"bytes", forecast->bytes},
              {"cpu_s", number_or_null(forecast->cpu_s)},
              {"solver_bytes", number_or_null(forecast->solver_bytes)},
              {"resident_bytes", number_or_null(forecast->resident_bytes)},
              {"measured_solver_bytes", number_or_null(bytes)},
              {"time_factor", factor}};
    // Each miss as a part of what is allowed: 1 is the limit.
    std::map<std::string, double> misses;
    const double longest = std::max(cpu, forecast->cpu_s);
    if (longest >= short_run_s || std::isnan(forecast->cpu_s))
      misses["time"] = time_miss(forecast->cpu_s + start_s, cpu + start_s, factor);
    if (bytes && !(std::max(*bytes, forecast->solver_bytes) < small_memory_bytes))
      misses["memory"] = std::abs(forecast->solver_bytes - *bytes) / (memory_tolerance * *bytes);
    // By then the crystal is there: nothing is left to guess, and what is seeded has no excuse.
    const auto at_contact = forecast_at_contact(run);
    if (at_contact && longest >= short_run_s)
      misses["contact"] = time_miss(*at_contact + start_s, cpu + start_s, 2.);
    misses["resident"] = std::abs(forecast->resident_bytes - resident) /
                         (memory_tolerance * resident + resident_slack_bytes);
    std::vector<std::string> judged{"time", "memory", "resident"};
    if (at_contact)
    {
      json["at_contact_cpu_s"] = number_or_null(at_contact);
      judged.push_back("contact");
    }
    double worst = 0.;
    for (const std::string &what : judged)
    {
      const auto found = misses.find(what);
      json[what] = found == misses.end() ? "not judged" : found->second <= 1. ? "met" : "missed";
      const bool gated =
          found != misses.end() && ((what != "time" && what != "contact") ||
                                    longest >= gated_run_s || std::isnan(found->second));
      if (gated && !std::isnan(worst)) // a forecast that is no number must not be outlived
        worst = std::isnan(found->second) ? found->second : std::max(worst, found->second);
    }
    json["worst_miss"] = number_or_null(worst);
    run["forecast"] = json;
  }

  Verdict forecast_verdict(const Json &run)
  {
    Verdict verdict =
        forecast_of(run.at("name"),
                    "memory of the solver within 10 %, resident memory within 10 % + 50 MB, CPU "
                    "time within a factor 2, or 3 where elements choose their steps or points are "
                    "seeded (2 of what is estimated at contact); time counts from 10 s of CPU on, "
                    "of shorter runs in sum, memory of the "
                    "solver from 1 MB on");
    verdict.check.take.run = run.at("name");
    if (!run.contains("forecast") || run.at("forecast").at("worst_miss").is_null())
    {
      verdict.why = "the solver predicted nothing, or what is no number";
      return verdict;
    }
    const Json &forecast = run.at("forecast");
    verdict.value = forecast.at("worst_miss").get<double>();
    verdict.status = *verdict.value <= 1. ? Status::pass : Status::fail;
    const auto megabytes = [](const Json &bytes)
    { return bytes.is_null() ? std::nan("") : bytes.get<double>() / 1e6; };
    verdict.why = fmt::format(
        "predicted over measured: CPU {:.3g}/{:.3g} s ({}), solver {:.3g}/{:.3g} MB ({}), resident "
        "{:.3g}/{:.3g} MB ({})",
        forecast.at("cpu_s").get<double>(), run.at("cpu_s").get<double>(),
        forecast.at("time").get<std::string>(), megabytes(forecast.at("solver_bytes")),
        megabytes(forecast.at("measured_solver_bytes")), forecast.at("memory").get<std::string>(),
        megabytes(forecast.at("resident_bytes")), megabytes(run.at("peak_rss_bytes")),
        forecast.at("resident").get<std::string>());
    if (forecast.contains("at_contact_cpu_s"))
      verdict.why +=
          fmt::format("; estimated at contact: CPU {:.3g}/{:.3g} s ({})",
                      forecast.at("at_contact_cpu_s").get<double>(), run.at("cpu_s").get<double>(),
                      forecast.at("contact").get<std::string>());
    return verdict;
  }

  std::optional<Verdict> short_runs_verdict(const std::vector<Json> &runs)
  {
    double predicted = 0., measured = 0., factor = 2.;
    int count = 0;
    for (const Json &run : runs)
    {
      const Json forecast = run.value("forecast", Json());
      if (!forecast.is_object() || !forecast.at("cpu_s").is_number())
        continue; // what is no number has failed on its own
      const double forecast_s = forecast.at("cpu_s"), measured_s = run.at("cpu_s");
      if (std::max(forecast_s, measured_s) >= gated_run_s)
        continue;
      ++count;
      predicted += forecast_s + start_s;
      measured += measured_s + start_s;
      factor = std::max(factor, forecast.at("time_factor").get<double>());
    }
    if (std::max(predicted, measured) < gated_run_s + count * start_s)
      return {};
    Verdict verdict = forecast_of(
        "short runs together",
        "CPU time of the runs of less than 10 s, which say little one by one, in sum within a "
        "factor 2, or 3 where one of them is of elements or its points are seeded");
    verdict.value = time_miss(predicted, measured, factor);
    verdict.status = *verdict.value <= 1. ? Status::pass : Status::fail;
    verdict.why =
        fmt::format("predicted over measured: CPU {:.3g}/{:.3g} s of {} runs, {:.2g} s for "
                    "the start of each",
                    predicted, measured, count, start_s);
    return verdict;
  }

  bool is_forecast(const Verdict &verdict)
  {
    return verdict.check.take.of == "forecast";
  }
} // namespace verify
