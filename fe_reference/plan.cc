#include "plan.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace fe
{
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

  std::string describe(const Plan &plan)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "  cells               " << plan.cells
         << "\n  unknowns            " << plan.unknowns << "\n  integration points  "
         << plan.integration_points << "\n  load steps          " << plan.load_steps
         << " (at least; more where Newton needs smaller ones or probes look in between)"
         << "\n  memory              "
         << (plan.factor_bytes + plan.state_bytes + plan.tangent_bytes) / 1e6 << " MB (factors "
         << plan.factor_bytes / 1e6 << ", tangent " << plan.tangent_bytes / 1e6 << ", state "
         << plan.state_bytes / 1e6 << ")\n  estimated time      " << plan.seconds
         << " s on one core\n";
    return text.str();
  }
} // namespace fe
