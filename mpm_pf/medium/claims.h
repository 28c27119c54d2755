// Which piece of the contour is nearest to which node, in one row of tiles (8 rows of nodes).
//
// Every piece claims the nodes that are nearer to it than to any earlier one. It need not ask all
// nodes within the band's reach: what it can own lies in a strip along its normal, half as wide as
// the way to the next piece (less than a cell), fanning out where the contour is curved. The strip
// is taken twice as wide as that. Should the contour be rougher than its curvatures say, a node
// may be left out; then the distance jumps from node to node by more than a distance can, and the
// caller asks again with all nodes in reach.
//
// Lengths are in units of spacing[0] throughout. In double precision: rounding to 1e-7 of a cell
// that comes out otherwise at the mirror image of a node is enough for a plastic crystal to lose
// its symmetry.
#pragma once

#include <vector>

#include "medium/mesh.h"
#include "medium/tiles.h"

namespace medium
{
  struct Distance;

  /// A piece seen from the nodes, and the strip in which it claims.
  struct Strip
  {
    double x, y;               // node number and height over row 0
    double normal_x, normal_y; // unit, into the solid
    double curvature;
    double per_x, per_y; // 1/normal_x, 1/normal_y; large where those vanish
    double width;        // half-width along the contour
  };

  /// The strips of all pieces.
  std::vector<Strip> strips_of(const Distance &, const Mesh &);

  struct Claims
  {
    /// Room for one row of tiles.
    explicit Claims(const Mesh &);

    static constexpr int line = 8; // nodes claimed side by side; a tile is four of them wide

    int pitch;
    std::vector<int> owner;        // piece, -1: none
    std::vector<double> square;    // squared distance to it
    std::vector<double> above;     // component along its normal, into the solid
    std::vector<double> aside;     // component along (-normal_y, normal_x)
    std::vector<double> curvature; // its curvature
    std::vector<double> size;      // what comes of it: the distance, unsigned
    std::vector<double> offset;    // and the place on the contour, from the piece
  };

  enum class Reach
  {
    strips,
    everything
  };

  /// Forgets all claims in the tiles of row `tile_row` that are active in `tiles`.
  void forget(Claims &, const Tiles &, int tile_row);

  /// Pieces that can reach a row of tiles, and how they ask.
  struct Claimants
  {
    int begin, end; // of the pieces
    Reach reach;
  };

  /// Lets them claim nodes of tile row `tile_row`.
  void claim(Claims &, const Distance &, const std::vector<Strip> &, const Mesh &, int tile_row,
             const Claimants &);
} // namespace medium
