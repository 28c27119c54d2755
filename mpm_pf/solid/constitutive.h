// From the new velocity gradient to new stress and position, for a range of points.
//
// Without cell averaging one pass does it all. With averaging there are three, since a mean needs
// all points of its cell: volume strains into the cells; stresses by Eqs. (5)-(6) and pressures
// into the cells; pressures relaxed and points moved, x += dt v. A point counts in the cell where
// it stood at the start of the step.
#pragma once

#include "solid/anti_locking.h"
#include "solid/stress.h"
#include "solid/transfer.h"

namespace solid
{
  /// What the points of one block give to the whole, summed in the order of the blocks.
  struct Share
  {
    double kinetic = 0., dissipated = 0.; // after the step; over the step
    double largest_speed2 = 0.;
    std::ptrdiff_t bad = -1; // first point that is lost, turned inside out or not finite
  };

  struct Step
  {
    double dt = 0.;
    Flow flow{};
    bool plastic = false;
    double inverse_density = 0.;
    double relaxation = 0.;
    Point lower, upper; // of the domain
    double speed_limit2 = 0.;
  };

  /// Find each point's cell and add the volume strain of the step to it.
  void collect_rates(const Points &, const Grid &, const Step &, CellMeans &, std::size_t begin,
                     std::size_t end);

  /// New stress, plastic strain and jacobian. `means` null: each point by itself; else pressures
  /// are added to the cells.
  void update_stress(Points &, const Step &, CellMeans *means, Share &, std::size_t begin,
                     std::size_t end);

  /// Relax pressures to their cells (`means` not null), move the points and check them.
  void move(Points &, const Moving &, const Step &, const CellMeans *means, Share &,
            std::size_t begin, std::size_t end);
} // namespace solid
