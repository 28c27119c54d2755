#include "melt/ledger.h"

namespace melt
{
  HeatLedger heat_ledger(const medium::Field<double> &phi, const medium::Field<double> &theta,
                         const medium::Mesh &mesh)
  {
    const double cell = mesh.spacing[0] * mesh.spacing[1];
    return {cell * medium::weighted_sum(theta, mesh),
            -0.5 * cell * medium::weighted_sum(phi, mesh)};
  }
} // namespace melt
