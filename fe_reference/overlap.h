// Does material lie where other material is?
//
// The finite elements know no contact: a body driven into another one, or folded onto itself, goes
// through it, in equilibrium and with positive Jacobians everywhere. Looked for are points of the
// outline that have come to lie in a cell which they do not belong to, by more than a twentieth of
// its size (sides that curve are taken as straight).
#pragma once

#include <optional>

#include "discretisation.h"

namespace fe
{
  /// Where, in the deformed body, a point of one piece's outline lies in a cell of another one;
  /// empty: nowhere.
  std::optional<Point> overlap_of_pieces(const Discretisation &, const std::vector<int> &piece,
                                         const std::vector<double> &u);
  /// The same of one piece with itself: cells beside those of the point, and those marked as
  /// folded, are left out.
  std::optional<Point> overlap_with_itself(const Discretisation &, const std::vector<int> &piece,
                                           const std::vector<double> &u,
                                           const std::vector<char> &folded);
} // namespace fe
