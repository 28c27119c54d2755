// The heat budget: what Eq. (2) must keep.
//
// d theta/dt = D lap theta + 1/2 d phi/dt: in a closed domain the integral of theta - phi/2 stays,
// to rounding, because the discrete latent heat is the very increment of phi and the discrete
// Laplacian is symmetric under the border weights (1/2 on sides, 1/4 in corners).
#pragma once

#include "medium/cuts.h"
#include "medium/field.h"

namespace melt
{
  struct HeatBudget
  {
    double sensible = 0.; // integral of theta, length^2
    double latent = 0.;   // integral of -phi/2, length^2
    double total() const { return sensible + latent; }
  };

  /// The budget of the fields as they are; `cuts`: only what the moving walls have left of them.
  HeatBudget heat_budget(const medium::Field<double> &phi, const medium::Field<double> &theta,
                         const medium::Mesh &, const medium::Cuts &cuts = {});
} // namespace melt
