#include "plan.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "load_stepping.h"
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

  Plan make_plan(const QuadMesh &mesh, const scene::Scene &scene)
  {
    const scene::Fe settings = scene.fe.value_or(scene::Fe{});
    const int degree = settings.degree;
    Plan plan;
    plan.cells = static_cast<int>(mesh.cells.size());
    // Euler: sides = vertices + cells - 1 for one piece without holes.
    const std::size_t sides = mesh.vertices.size() + mesh.cells.size() - 1;
    const std::size_t nodes = mesh.vertices.size() + (degree == 2 ? sides + mesh.cells.size() : 0);
    plan.unknowns = static_cast<int>(2 * nodes);
    plan.integration_points = plan.cells * (degree + 1) * (degree + 1);
    plan.load_steps = settings.load_steps;

    const double n = plan.unknowns;
    constexpr double operations_per_second = 1.5e9; // of the factorisation with reference BLAS
    constexpr double iterations_per_step = 3.5;
    const double unknowns_per_cell = degree == 1 ? 8. : 18.;
    plan.factor_bytes = 8. * 8. * n * std::log2(n);
    plan.state_bytes = 3. * plan.integration_points * sizeof(PointState) + 12. * 8. * n;
    plan.tangent_bytes = plan.cells * unknowns_per_cell * unknowns_per_cell * 16.;
    const double factorisation = 30. * std::pow(n, 1.5) * 4. / operations_per_second;
    const double assembly = 4e-6 * plan.integration_points;
    plan.seconds = plan.load_steps * iterations_per_step * (factorisation + assembly);
    return plan;
  }

  void time_first_steps(Plan &plan, const Problem &problem, const scene::Scene &scene,
                        const std::vector<double> &sampling_times)
  {
    // Yielding takes more corrections than the elastic steps in which every load begins.
    constexpr double iterations_when_yielding = 5.;
    constexpr double budget_s = 1.;
    LinearSystem system(problem.mesh);
    const double begin = record::cpu_seconds();
    Course course;
    course.load_steps = 2;
    course.end = 2. * scene.clock.end / plan.load_steps;
    course.observe = [](const Step &) {};
    course.interrupted = [&] { return record::cpu_seconds() - begin > budget_s; };
    const Outcome outcome = follow(problem, system, initial_state(problem, scene), course);
    const double spent = record::cpu_seconds() - begin;
    const double iterations = std::max(1, outcome.pace.iterations);
    const double steps = std::max(1, outcome.pace.steps);
    plan.load_steps = increments(scene.clock.end, plan.load_steps, sampling_times);
    const double each = scene.solid->yield_stress
                            ? std::max(iterations_when_yielding, iterations / steps)
                            : iterations / steps;
    plan.seconds = begin + plan.load_steps * each * spent / iterations;
    plan.resident_bytes = record::peak_rss_bytes();
  }

  std::string describe(const Plan &plan)
  {
    std::ostringstream text;
    text << std::setprecision(4) << "  cells               " << plan.cells
         << "\n  unknowns            " << plan.unknowns << "\n  integration points  "
         << plan.integration_points << "\n  load steps          " << plan.load_steps
         << " (at least; more where Newton needs smaller ones or probes look in between)"
         << "\n  memory              "
         << (plan.factor_bytes + plan.state_bytes + plan.tangent_bytes) / 1e6 << " MB (factors "
         << plan.factor_bytes / 1e6 << ", tangent " << plan.tangent_bytes / 1e6 << ", state "
         << plan.state_bytes / 1e6 << ")\n  estimated time      " << plan.seconds
         << " s of CPU\nforecast cpu_s=" << plan.seconds
         << " solver_bytes=" << plan.factor_bytes + plan.state_bytes + plan.tangent_bytes
         << " resident_bytes=" << plan.resident_bytes << "\n";
    return text.str();
  }
} // namespace fe
