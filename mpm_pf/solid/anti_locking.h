// Volume changes shared within a cell, against locking; and what must come with it.
//
// Plastic flow keeps the volume, and a few points in a cell demand that at more places than the
// cell has freedom for: it locks (end force of the sheared bar +18 % at 10 cells). So the
// volumetric strain of the step is averaged over the points of each cell, weighted with volume.
// Averaging alone has a null space: the points of one cell never exchange pressure, carry it into
// other cells, and end up alternating by two yield stresses, which softens the section until it
// tears. Hence each pressure is also relaxed towards the mean of its cell,
//   p_p += r (p_cell - p_p),   r = 0.1 a step (0.01 to 1 give the same);
// deviators, and so the yield condition, are not touched. The volume goes with the pressure,
//   J_p *= exp(-r (p_cell - p_p)/K),
// which leaves that of the cell as it is. Left out, J and pressure part for good: a point that a
// wall held at the end of its contact, half its steps in a cell of its own, was shrunk to nothing
// at a pressure of a third of the yield stress.
//
// Both means are known before any stress is updated. All points of a cell get the same volume
// strain e, which changes their pressures by the same -K e and their volumes by the same factor;
// plastic flow does not change the pressure. So relaxing the new pressures towards their mean is
// relaxing the old ones towards theirs: one sum over the points, then the stresses.
#pragma once

#include "solid/grid.h"

namespace solid
{
  struct Piece;
  struct Step;

  /// The cell whose lower left node is n has index n. Empty when averaging is off.
  struct CellMeans
  {
    struct Mean
    {
      double strain, pressure; // of volume in this step; at its start
    };
    struct Sum
    {
      Quad value; // {volume, volume x strain, volume x pressure, 0}
    };
    /// From even and from odd blocks, because the cells between two blocks get points from both.
    std::array<Array<Sum>, 2> sums;
    Array<Mean> mean;
    Array<std::int32_t> cell; // of each point during a step

    void resize(const std::size_t nodes, const std::size_t points)
    {
      sums[0].resize(nodes), sums[1].resize(nodes), mean.resize(nodes), cell.resize(points);
    }
  };

  /// Zero sums for the cells that points of this block may be in.
  void clear_cells(CellMeans &, const Grid &, int block);

  /// Find the cells of some points of a block and add them to these.
  void add_to_cells(CellMeans &, const Points &, const Grid &, const Step &, const Piece &);

  /// Means in the rows of cells from the lower side of a block to below its upper side (the last
  /// block: to the end). Requires the sums of the block and of the one before.
  void average_cells(CellMeans &, const Grid &, int block);
} // namespace solid
