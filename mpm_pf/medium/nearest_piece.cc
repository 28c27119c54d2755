#include "medium/nearest_piece.h"

#include <algorithm>

namespace medium
{
  namespace
  {
    struct Sweeper
    {
      Field<int> &map;
      const Distance &distance;
      const Mesh &mesh;

      double square(int piece, int i, int j) const
      {
        const ContourPiece &at = distance.pieces[static_cast<std::size_t>(piece)];
        const double x = mesh.lower[0] + i * mesh.spacing[0] - at.x,
                     y = mesh.lower[1] + j * mesh.spacing[1] - at.y;
        return x * x + y * y;
      }
      void ask(int i, int j, int neighbour, int &best, double &least) const
      {
        if (neighbour < 0 || neighbour == best)
          return;
        const double offered = square(neighbour, i, j);
        if (best < 0 || offered < least)
          best = neighbour, least = offered;
      }
      /// One row, first in the direction of the sweep from the row behind, then back.
      void row(int j, int behind) const
      {
        const int nx = mesh.nodes[0];
        int *here = map.row(j);
        const int *before = behind < 0 || behind >= mesh.nodes[1] ? nullptr : map.row(behind);
        for (const int step : {1, -1})
          for (int i = step > 0 ? 0 : nx - 1; i >= 0 && i < nx; i += step)
          {
            if (distance.piece(i, j) >= 0)
              continue;
            int best = here[i];
            double least = best < 0 ? 0. : square(best, i, j);
            if (i - step >= 0 && i - step < nx)
              ask(i, j, here[i - step], best, least);
            if (before && step > 0)
              for (int n = std::max(i - 1, 0); n <= std::min(i + 1, nx - 1); ++n)
                ask(i, j, before[n], best, least);
            here[i] = best;
          }
      }
    };
  } // namespace

  void find_nearest_piece(Field<int> &map, const Distance &distance, const Mesh &mesh)
  {
    for (int j = 0; j < mesh.nodes[1]; ++j)
      std::copy_n(distance.piece.row(j), mesh.nodes[0], map.row(j));
    const Sweeper sweeper{map, distance, mesh};
    for (int j = 0; j < mesh.nodes[1]; ++j)
      sweeper.row(j, j - 1);
    for (int j = mesh.nodes[1] - 1; j >= 0; --j)
      sweeper.row(j, j + 1);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        map(i, j) = std::max(map(i, j), 0);
  }
} // namespace medium
