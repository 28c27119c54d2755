#include "kernels.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <vector>

#include <benchmark/benchmark.h>
#include <omp.h>

#include "record/atomic_write.h"

namespace kernels
{
  namespace
  {
    constexpr int triad_nodes = 1200 * 800;

    std::map<std::string, Goal> &goals()
    {
      static std::map<std::string, Goal> all;
      return all;
    }

    /// Keeps the best CPU time per iteration of every benchmark, in seconds.
    class Best : public benchmark::BenchmarkReporter
    {
    public:
      bool ReportContext(const Context &) override { return true; }
      void ReportRuns(const std::vector<Run> &runs) override
      {
        for (const Run &run : runs)
          if (run.run_type == Run::RT_Iteration && !run.error_occurred)
          {
            const std::string name = run.run_name.function_name;
            const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
            const auto known = seconds_of.find(name);
            if (known == seconds_of.end() || seconds < known->second)
              seconds_of[name] = seconds;
          }
      }
      std::map<std::string, double> seconds_of;
    };

    void add_triad()
    {
      add("triad", {triad_nodes, 1., 1.},
          []
          {
            struct Arrays
            {
              std::vector<double> a, b, c;
            };
            auto arrays = std::make_shared<Arrays>(Arrays{std::vector<double>(triad_nodes),
                                                          std::vector<double>(triad_nodes, 1.),
                                                          std::vector<double>(triad_nodes, 2.)});
            return [arrays]
            {
              double *a = arrays->a.data();
              const double *b = arrays->b.data(), *c = arrays->c.data();
#pragma omp simd
              for (int i = 0; i < triad_nodes; ++i)
                a[i] = b[i] + 3. * c[i];
              benchmark::ClobberMemory();
            };
          });
    }

    /// The report as JSON; `worst` becomes the largest of all kernels' triads over their limit.
    std::string as_json(const Best &best, double &worst)
    {
      const double triad = best.seconds_of.at("triad") / triad_nodes;
      std::ostringstream text;
      text << "{\n  \"triad_ns_per_node\": " << triad * 1e9 << ",\n  \"kernels\": [";
      const char *comma = "\n";
      for (const auto &[name, seconds] : best.seconds_of)
      {
        const Goal &goal = goals().at(name);
        const double item = seconds / goal.items, triads = item / triad;
        const bool met = triads <= goal.triads;
        worst = std::max(worst, triads / goal.triads);
        text << comma << "    {\"name\": \"" << name << "\", \"ns_per_item\": " << item * 1e9
             << ", \"triads\": " << triads << ", \"limit\": " << goal.triads
             << ", \"stretch\": " << goal.stretch << ", \"status\": \"" << (met ? "pass" : "fail")
             << "\"}";
        comma = ",\n";
      }
      text << "\n  ]\n}\n";
      return text.str();
    }

    /// Takes `--slack=F` out of the arguments; 1 without it.
    double take_slack(std::vector<char *> &arguments)
    {
      const std::string name = "--slack=";
      double slack = 1.;
      for (auto it = arguments.begin(); it != arguments.end();)
        if (const std::string text = *it; text.rfind(name, 0) == 0)
        {
          slack = std::stod(text.substr(name.size()));
          it = arguments.erase(it);
        }
        else
          ++it;
      return slack;
    }
  } // namespace

  void add(const std::string &name, const Goal &goal,
           const std::function<std::function<void()>()> &set_up)
  {
    goals()[name] = goal;
    auto iteration = std::make_shared<std::function<void()>>();
    benchmark::RegisterBenchmark(name.c_str(),
                                 [iteration, set_up](benchmark::State &state)
                                 {
                                   if (!*iteration)
                                     *iteration = set_up();
                                   for (auto round : state)
                                   {
                                     (void)round;
                                     (*iteration)();
                                   }
                                 })
        ->Unit(benchmark::kMillisecond);
  }

  medium::Mesh mesh_of(int nx, int ny)
  {
    medium::Mesh mesh;
    mesh.nodes = {nx, ny};
    mesh.spacing = {0.4, 0.4};
    mesh.boundary.fill(medium::Boundary::symmetry);
    return mesh;
  }
} // namespace kernels

/// kernels [FILE.json] [--slack=F] [--benchmark_...]: prints the report, writes it to FILE, and
/// ends with 1 where a kernel needs more triads than F times its limit (F = 1 without --slack).
/// Where cores are shared a neighbour slows what computes more than what waits for memory, so that
/// ratios rise by up to a half: a gate there needs slack, a claim does not get any.
int main(int argc, char **argv)
{
  omp_set_num_threads(1);
  std::vector<char *> arguments(argv, argv + argc);
  const double slack = kernels::take_slack(arguments);
  std::string repetitions = "--benchmark_repetitions=7",
              shuffle = "--benchmark_enable_random_interleaving=true",
              shortest = "--benchmark_min_time=0.1";
  for (std::string *option : {&shortest, &shuffle, &repetitions})
    arguments.insert(arguments.begin() + 1,
                     option->data()); // what the caller says comes later, wins
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  kernels::add_triad();
  kernels::add_growth_kernels();
  kernels::add_advection_kernels();
  kernels::add_solid_kernels();
  kernels::Best best;
  benchmark::RunSpecifiedBenchmarks(&best);
  if (!best.seconds_of.count("triad"))
  {
    std::fputs("kernels: the triad was filtered out, so there is no unit\n", stderr);
    return 2;
  }
  double worst = 0.;
  const std::string report = kernels::as_json(best, worst);
  std::fputs(report.c_str(), stdout);
  if (count > 1)
    try
    {
      record::write_atomically(arguments[1], report);
    }
    catch (const std::filesystem::filesystem_error &error)
    {
      std::fprintf(stderr, "kernels: %s: %s\n", arguments[1], error.code().message().c_str());
      return 2;
    }
  return worst > slack ? 1 : 0;
}
