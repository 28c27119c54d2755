#include "medium/contour_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medium
{
  namespace
  {
    /// The box round the pieces in one tile.
    struct Box
    {
      double left = std::numeric_limits<double>::max(), right = -left, low = left, high = -left;
      void add(const ContourPiece &piece)
      {
        left = std::min(left, piece.x), right = std::max(right, piece.x);
        low = std::min(low, piece.y), high = std::max(high, piece.y);
      }
    };

    int tile_of(double place, const Mesh &mesh, int axis, int size, int count)
    {
      const double node = std::floor((place - mesh.lower[axis]) / mesh.spacing[axis]);
      return std::min(std::max(static_cast<int>(node) / size, 0), count - 1);
    }

    /// Makes the tiles active that come within `reach` of a box.
    void mark(Tiles &tiles, const std::vector<Box> &boxes, double reach, const Mesh &mesh)
    {
      std::fill(tiles.activity.begin(), tiles.activity.end(), Activity::frozen);
      const auto column_of = [&](double x)
      { return tile_of(x, mesh, 0, Tiles::width, tiles.columns); };
      const auto row_of = [&](double y) { return tile_of(y, mesh, 1, Tiles::height, tiles.rows); };
      for (const Box &box : boxes)
        if (box.left <= box.right)
          for (int row = row_of(box.low - reach); row <= row_of(box.high + reach); ++row)
            for (int column = column_of(box.left - reach); column <= column_of(box.right + reach);
                 ++column)
              tiles.at(column, row) = Activity::active;
    }
  } // namespace

  void mark_tiles(Distance &distance, const Mesh &mesh)
  {
    Tiles &tiles = distance.tiles;
    std::vector<Box> boxes(tiles.activity.size());
    for (const ContourPiece &piece : distance.pieces)
      boxes[tiles.index(tile_of(piece.x, mesh, 0, Tiles::width, tiles.columns),
                        tile_of(piece.y, mesh, 1, Tiles::height, tiles.rows))]
          .add(piece);
    mark(tiles, boxes, distance.band, mesh);
    mark(distance.close, boxes, follow_cells * mesh.spacing.maxCoeff(), mesh);
  }
} // namespace medium
