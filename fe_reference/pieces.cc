#include "pieces.h"

#include <numeric>

namespace fe
{
  std::vector<int> connected_pieces(const int vertices, const std::vector<int> &cell_vertices,
                                    const int per_cell)
  {
    std::vector<int> piece(vertices);
    std::iota(piece.begin(), piece.end(), 0);
    const auto root = [&piece](int i)
    {
      while (piece[i] != i)
        i = piece[i] = piece[piece[i]];
      return i;
    };
    for (std::size_t k = 0; k < cell_vertices.size(); ++k)
      piece[root(cell_vertices[k])] = root(cell_vertices[k - k % per_cell]);
    for (int i = 0; i < vertices; ++i)
      piece[i] = root(i);
    return piece;
  }
} // namespace fe
