// One load increment: Newton's method with line search on the out-of-balance force.
//
// The first correction starts from a guess and carries the held displacements to their values at
// the new time through the tangent (a jump of the boundary alone would turn the elements beside it
// inside out). From then on held displacements stay and only the free ones move; each correction is
// halved until the residual falls, and the best try is taken if none does (yielding points switch
// and may lift the residual for one iteration).
#pragma once

#include <string>
#include <vector>

#include "assembly.h"

namespace fe
{
  struct NewtonReport
  {
    bool converged = false;
    int iterations = 0;
    std::vector<double> residuals; // norms over free unknowns, relative to the force scale
    std::string failure;           // why not
    std::string remedy;            // where no smaller increment helps; else empty
    int worst_unknown = 0;         // largest out-of-balance force
    int determinant_sign = 0;      // of the last tangent; 0: not known
  };

  /// Find the equilibrium at `now.time` from `old`, starting at `now.u`. On success `now` is
  /// complete; else it is not usable, `failure` says why.
  NewtonReport find_equilibrium(const Problem &, LinearSystem &, const State &old, State &now);
} // namespace fe
