// Volume changes shared within a cell, against locking; and what must come with it.
//
// Plastic flow keeps the volume, and a few points in a cell demand that at more places than the
// cell has freedom for: it locks (end force of the sheared bar +18 % at 10 cells). So the
// volumetric strain of the step is averaged over the points of each cell, weighted with volume.
// Averaging alone has a null space: the points of one cell never exchange pressure, carry it into
// other cells, and end up alternating by two yield stresses, which softens the section until it
// tears. Hence each pressure is relaxed towards the mean of its cell after the stress update,
//   p_p += r (p_cell - p_p),   r = 0.1 a step (0.01 to 1 give the same);
// deviators, and so the yield condition, are not touched.
#pragma once

#include "solid/grid.h"

namespace solid
{
  struct CellSum
  {
    double volume, value; // sum of volumes, sum of volume times value
    double mean(const double otherwise) const { return volume > 0. ? value / volume : otherwise; }
  };

  /// Sums of the cell whose lower left node is n, at index n. Empty when averaging is off.
  struct CellMeans
  {
    Array<CellSum> rate, pressure;
    Array<std::int32_t> cell; // of each point during a step

    void resize(const std::size_t nodes, const std::size_t points)
    {
      rate.resize(nodes), pressure.resize(nodes), cell.resize(points);
    }
  };
} // namespace solid
