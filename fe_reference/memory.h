// Bytes that the solver holds, by what they are for; counted, not measured from outside.
#pragma once

#include <map>
#include <string>

#include "assembly.h"

namespace fe
{
  /// Of this process, once the tangent has been factorised: `mesh` (deal.II's objects, node tables,
  /// shape functions), `states` (two equilibria and what Newton tries), `tangent` (sparse matrix
  /// and where each element's entries go), `factors` (MUMPS's own account of what it allocated, and
  /// the triplets that it is given).
  std::map<std::string, double> memory(const Problem &, const LinearSystem &);
} // namespace fe
