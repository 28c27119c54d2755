// The edge of stability in a map: where it lies, found by bisection, and what it is of the
// theoretical limit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stability_cells.h"

namespace verify
{
  struct Edge
  {
    std::size_t row = 0;
    double stable = 0., unstable = 0.;
    std::string stopped;          // class of a cell between the two that is neither: no finer edge
    std::optional<double> theory; // the theoretical limit of this row

    double middle() const { return 0.5 * (stable + unstable); }
    std::optional<double> ratio() const; // to the theoretical limit
  };

  /// Between each two neighbours of a row, one stable and one not, whose x are numbers, refined as
  /// often as the map asks for; the cells run for that are added to `bisected`.
  std::vector<Edge> find_edges(const Mapper &, const Map &, std::size_t number,
                               const std::vector<Cell> &, std::vector<Cell> &bisected);

  /// One sentence for each row that breaks the map's bounds `edge`: an edge outside of them, or
  /// none where all that was judged is stable beyond them, or unstable before them.
  std::vector<std::string> broken_bounds(const Map &, const std::vector<Cell> &,
                                         const std::vector<Edge> &, const Constants &);
} // namespace verify
