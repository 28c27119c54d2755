#include "medium/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medium
{
  namespace
  {
    /// Nodes [begin, end) of one row of the scratch, whole lines of them, at height dy over a
    /// piece.
    struct Lines
    {
      int row, begin, end;
      double dy;
    };

    /// They are claimed for piece `index`.
    void claim_row(Claims &claims, const Lines lines, const Strip strip, int index)
    {
      const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(lines.row) * claims.pitch;
      const double nx = strip.normal_x, ny = strip.normal_y, dy = lines.dy, dy2 = dy * dy;
      for (int i = lines.begin; i < lines.end; i += Claims::line)
      {
        int *owner = claims.owner.data() + start + i;
        double *square = claims.square.data() + start + i, *above = claims.above.data() + start + i,
               *aside = claims.aside.data() + start + i,
               *curvature = claims.curvature.data() + start + i;
        const double first = i - strip.x;
#pragma omp simd
        for (int n = 0; n < Claims::line; ++n)
        {
          const double dx = first + static_cast<double>(n), offered = dx * dx + dy2;
          const bool nearer = offered < square[n];
          square[n] = nearer ? offered : square[n];
          owner[n] = nearer ? index : owner[n];
          above[n] = nearer ? dx * nx + dy * ny : above[n];
          aside[n] = nearer ? dy * nx - dx * ny : aside[n];
          curvature[n] = nearer ? strip.curvature : curvature[n];
        }
      }
    }

    double inverse(double x)
    {
      constexpr double least = 1e-6;
      return 1. / (std::abs(x) > least ? x : x < 0. ? -least : least);
    }
  } // namespace

  std::vector<Strip> strips_of(const Distance &distance, const Mesh &mesh)
  {
    const double h = mesh.spacing[0], ratio = mesh.spacing[1] / h, band = distance.band / h;
    // Pieces are at most the diagonal of a cell apart; across a circle's radius the gap fans out.
    const double gap = std::sqrt(1. + ratio * ratio);
    std::vector<Strip> strips;
    strips.reserve(distance.pieces.size());
    for (const ContourPiece &piece : distance.pieces)
    {
      const double curvature = piece.curvature * h,
                   width = 0.9 * gap * (1. + 1.25 * std::abs(curvature) * band);
      strips.push_back({(piece.x - mesh.lower[0]) / h, (piece.y - mesh.lower[1]) / h,
                        piece.normal_x, piece.normal_y, curvature, inverse(piece.normal_x),
                        inverse(piece.normal_y), std::min(width, band)});
    }
    return strips;
  }

  Claims::Claims(const Mesh &mesh)
      : pitch((mesh.nodes[0] + Tiles::width - 1) / Tiles::width * Tiles::width)
  {
    const auto nodes = static_cast<std::size_t>(pitch) * Tiles::height;
    owner.resize(nodes);
    for (std::vector<double> *numbers : {&square, &above, &aside, &curvature, &size, &offset})
      numbers->resize(nodes);
  }

  void forget(Claims &claims, const Tiles &tiles, int tile_row)
  {
    for (int column = 0; column < tiles.columns; ++column)
    {
      if (tiles.at(column, tile_row) != Activity::active)
        continue;
      for (int row = 0; row < Tiles::height; ++row)
      {
        const std::ptrdiff_t start =
            static_cast<std::ptrdiff_t>(row) * claims.pitch + tiles.first_node(column);
        std::fill_n(claims.owner.data() + start, Tiles::width, -1);
        std::fill_n(claims.square.data() + start, Tiles::width, std::numeric_limits<double>::max());
      }
    }
  }

  void claim(Claims &claims, const Distance &distance, const std::vector<Strip> &strips,
             const Mesh &mesh, int tile_row, const Claimants &claimants)
  {
    const double ratio = mesh.spacing[1] / mesh.spacing[0];
    const double reach = distance.band / mesh.spacing[0];
    const int j0 = distance.tiles.first_row(tile_row), j1 = distance.tiles.end_row(tile_row);
    const int last = mesh.nodes[0] - 1;
    for (int k = claimants.begin; k < claimants.end; ++k)
    {
      const Strip strip = strips[static_cast<std::size_t>(k)]; // a copy: nothing written aliases it
      const double width = claimants.reach == Reach::strips ? strip.width : reach;
      const double reach_x = std::abs(reach * strip.per_x), width_x = std::abs(width * strip.per_y);
      const double tall = std::abs(strip.normal_y) * reach + std::abs(strip.normal_x) * width;
      for (int j = j0; j < j1; ++j)
      {
        const double dy = j * ratio - strip.y;
        if (std::abs(dy) > std::min(tall, reach))
          continue;
        // |dx nx + dy ny| <= reach and |dy nx - dx ny| <= width
        const double in_reach = -dy * strip.normal_y * strip.per_x,
                     in_strip = dy * strip.normal_x * strip.per_y;
        const double left = strip.x + std::max({in_reach - reach_x, in_strip - width_x, -reach}),
                     right = strip.x + std::min({in_reach + reach_x, in_strip + width_x, reach});
        const int i0 = std::max(0, static_cast<int>(left)),
                  i1 = std::min(last, static_cast<int>(right));
        claim_row(claims, {j - j0, i0 / Claims::line * Claims::line, i1 + 1, dy}, strip, k);
      }
    }
  }
} // namespace medium
