#include "plan.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "load_stepping.h"
#include "memory.h"
#include "record/provenance.h"

namespace fe
{
  namespace
  {
    /// Increments from 0 to the end where none passes a sampling time.
    int increments(const double end, const int load_steps,
                   const std::vector<double> &sampling_times)
    {
      const double nominal = end / load_steps;
      std::vector<double> stops = sampling_times;
      stops.push_back(end);
      std::sort(stops.begin(), stops.end());
      int count = 0;
      double time = 0.;
      for (const double stop : stops)
        if (stop > time + 1e-9 * nominal && stop <= end * (1. + 1e-9))
        {
          count += static_cast<int>(std::ceil((stop - time) / nominal * (1. - 1e-6)));
          time = stop;
        }
      return count;
    }
  } // namespace

  Plan make_plan(const Problem &problem, const scene::Scene &scene,
                 const std::vector<double> &sampling_times)
  {
    // Yielding takes more corrections than the elastic steps in which every load begins; so many in
    // the middle of the cases here, whose runs take 0.37 (elastic, carried) to 2.6 (a squeezed
    // dendrite's finest mesh, whose corner cells fold) of what this forecasts.
    constexpr double iterations_when_yielding = 3.5;
    constexpr double budget_s = 0.5;
    constexpr int most_steps = 10;
    Plan plan;
    plan.cells = problem.mesh.cells;
    plan.unknowns = problem.mesh.unknowns();
    plan.integration_points = plan.cells * problem.mesh.points_per_cell;
    const int load_steps = scene.fe.value_or(scene::Fe{}).load_steps;
    plan.load_steps = increments(scene.clock.end, load_steps, sampling_times);

    LinearSystem system(problem.mesh);
    const double begin = record::cpu_seconds();
    // The first step also orders the matrix and touches all memory for the first time: what it
    // takes counts once, the steps after it set the pace of the rest.
    double first_end = begin, last_end = begin;
    int first_iterations = 0, last_iterations = 0, steps = 0;
    SteppingOptions options;
    options.load_steps = std::min(most_steps, load_steps); // no further than the run goes
    options.end = options.load_steps * scene.clock.end / load_steps;
    options.observe = [&](const Step &step)
    {
      steps = step.stepping.steps;
      last_end = record::cpu_seconds(), last_iterations = step.stepping.iterations;
      if (steps <= 1)
        first_end = last_end, first_iterations = last_iterations;
    };
    options.interrupted = [&]
    {
      const bool enough = steps >= 2 && record::cpu_seconds() - begin > budget_s;
      return sum_over_processes(enough ? 1. : 0.) > 0.;
    };
    const Outcome outcome = run_load_steps(problem, system, initial_state(problem, scene), options);
    const bool paced = last_iterations > first_iterations;
    const double iterations =
        std::max(1, paced ? last_iterations - first_iterations : outcome.stepping.iterations);
    const double spent = paced ? last_end - first_end : record::cpu_seconds() - begin;
    const double of_a_step = iterations / std::max(1, paced ? steps - 1 : outcome.stepping.steps);
    const double each = scene.solid->yield_stress && steps * 2 < plan.load_steps
                            ? std::max(iterations_when_yielding, of_a_step)
                            : of_a_step;
    plan.seconds = first_end + plan.load_steps * each * spent / iterations;
    plan.resident_bytes = record::peak_rss_bytes();
    plan.bytes = memory(problem, system);
    if (outcome.kind == Outcome::Kind::diverged)
      plan.trouble = outcome.message;
    return plan;
  }

  std::string describe(const Plan &plan)
  {
    std::ostringstream text;
    text << std::setprecision(4) << "  cells               " << plan.cells
         << "\n  unknowns            " << plan.unknowns << "\n  integration points  "
         << plan.integration_points << "\n  load steps          " << plan.load_steps
         << " (at least; more where Newton needs smaller ones)\n";
    double sum = 0.;
    for (const auto &[what, bytes] : plan.bytes)
    {
      text << "  memory, " << what << ": " << bytes / 1e6 << " MB\n";
      sum += bytes;
    }
    text << "  memory, all modules: " << sum / 1e6 << " MB; resident " << plan.resident_bytes / 1e6
         << " MB\n  estimated time      " << plan.seconds
         << " s of CPU\nforecast cpu_s=" << plan.seconds << " solver_bytes=" << sum
         << " resident_bytes=" << plan.resident_bytes << "\n";
    return text.str();
  }
} // namespace fe
