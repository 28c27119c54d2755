#include "forecasts.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "written.h"

namespace verify
{
  namespace
  {
    constexpr double memory_tolerance = 0.10, resident_slack_bytes = 50e6;
    constexpr double small_memory_bytes = 1e6; // below it a page decides, not the solver
    // Starting a program and opening its record is no part of the forecast and hardly repeats.
    constexpr double start_s = 0.15;

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

    bool sown(const Json &run)
    {
      return run.contains("profile") && run.at("profile").contains("growth_steps") &&
             run.at("profile").contains("points");
    }

    const char *word(const bool met)
    {
      return met ? "met" : "missed";
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
    const double factor = run.at("solver") == "fe_reference" || sown(run) ? 3. : 2.;
    Json json{{"on", forecast->on},
              {"off", forecast->off},
              {"bytes", forecast->bytes},
              {"cpu_s", number_or_null(forecast->cpu_s)},
              {"solver_bytes", number_or_null(forecast->solver_bytes)},
              {"resident_bytes", number_or_null(forecast->resident_bytes)},
              {"measured_solver_bytes", number_or_null(bytes)}};
    const double low = std::max(0., cpu - start_s) / factor, high = (cpu + start_s) * factor;
    json["time"] = word(forecast->cpu_s >= low && forecast->cpu_s <= high);
    json["time_factor"] = factor;
    json["memory"] = "not measured";
    if (bytes)
      json["memory"] = word(std::abs(forecast->solver_bytes - *bytes) <=
                            std::max(memory_tolerance * *bytes, small_memory_bytes));
    json["resident"] = word(std::abs(forecast->resident_bytes - resident) <=
                            memory_tolerance * resident + resident_slack_bytes);
    run["forecast"] = json;
  }
} // namespace verify
