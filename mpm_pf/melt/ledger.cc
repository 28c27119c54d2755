#include "melt/ledger.h"

namespace melt
{
  HeatLedger heat_ledger(const medium::Field<double> &phi, const medium::Field<double> &theta,
                         const medium::Mesh &mesh, const medium::Cuts *cuts)
  {
    const double cell = mesh.spacing[0] * mesh.spacing[1];
    const auto sum = [&](const medium::Field<double> &field)
    { return cuts ? medium::weighted_sum(field, mesh, *cuts) : medium::weighted_sum(field, mesh); };
    return {cell * sum(theta), -0.5 * cell * sum(phi)};
  }
} // namespace melt
