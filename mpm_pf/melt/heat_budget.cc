#include "melt/heat_budget.h"

#include "medium/sums.h"

namespace melt
{
  HeatBudget heat_budget(const medium::Field<double> &phi, const medium::Field<double> &theta,
                         const medium::Mesh &mesh, const medium::Cuts &cuts)
  {
    const double cell = mesh.spacing.prod();
    return {cell * medium::weighted_sum(theta, mesh, cuts),
            -0.5 * cell * medium::weighted_sum(phi, mesh, cuts)};
  }
} // namespace melt
