#include "plan.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
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

    /// Newton iterations of an increment in which a cell strains by so many yield strains. Measured
    /// in runs of shear, punch, tension_compression and dendrite_squeeze, with other meshes,
    /// increments and moduli: 2.1 to 4.4 where this says 3.0 to 4.5, more the finer the mesh and
    /// the longer the increment; 4.4 where it says 6.9, with four times the modulus; 7.4 where it
    /// says 5.5, on a mesh whose corner cells fold and halve increments. Rate-dependent flow takes
    /// fewer (1.1 to 1.5).
    double iterations_when_yielding(const double strains)
    {
      return 3. + strains / 70.;
    }
  } // namespace

  double yield_strains(const Problem &problem, const double end, const int load_steps)
  {
    if (!problem.material.yield_stress)
      return 0.;
    const Discretisation &d = problem.mesh;
    std::vector<double> u(d.unknowns(), 0.);
    double travel = 0.;
    for (int k = 1; k <= load_steps; ++k)
    {
      const std::vector<double> next = impose(problem.supports, d, u, end * k / load_steps);
      double apart = 0.;
      for (int c = 0; c < 2; ++c)
      {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int n = 0; n < d.nodes; ++n)
          if (const int i = 2 * n + c; problem.supports.is_held[i])
          {
            least = std::min(least, next[i] - u[i]);
            most = std::max(most, next[i] - u[i]);
          }
        apart = std::max(apart, most - least); // minus infinity where nothing is held
      }
      travel += apart;
      u = next;
    }
    const double area = std::accumulate(d.weight.begin(), d.weight.end(), 0.);
    const double G = problem.material.shear_modulus, lame = problem.material.lame;
    const double young_modulus = G * (3. * lame + 2. * G) / (lame + G);
    return travel / std::sqrt(area / d.cells) * young_modulus / *problem.material.yield_stress;
  }

  Plan make_plan(const Problem &problem, const scene::Scene &scene,
                 const std::vector<double> &sampling_times)
  {
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
    const double taken = std::max(1, paced ? steps - 1 : outcome.stepping.steps);
    double each = iterations / taken;
    // Yielding takes more corrections than the elastic steps in which every load begins, and its
    // first step more than those after it: the steps taken count beside ten that are typical.
    if (scene.solid->yield_stress && steps * 2 < plan.load_steps)
    {
      constexpr double typical = 10.;
      const double strains = yield_strains(problem, scene.clock.end, load_steps) / plan.load_steps;
      each = (typical * iterations_when_yielding(strains) + iterations) / (typical + taken);
    }
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
