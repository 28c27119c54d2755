// Which parts of a mesh hang together.
#pragma once

#include <vector>

namespace fe
{
  /// For every vertex one vertex of its piece, the same for all of it: pieces share no vertex.
  /// `cell_vertices` holds `per_cell` numbers for each cell.
  std::vector<int> connected_pieces(int vertices, const std::vector<int> &cell_vertices,
                                    int per_cell);
} // namespace fe
