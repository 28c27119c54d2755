// From the new velocity gradient to new stress and position, for a range of points.
//
// With cell averaging there are two passes, since a mean needs all points of its cell: gather, add
// to the cells and move, x += dt v; then, cells averaged, the stresses by Eqs. (5)-(6). A point
// counts in the cell where it stood at the start of the step.
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
    double strained = 0.;                 // work of the stresses on the strains over the step
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

  /// New stress, plastic strain and jacobian, and a check of them. `means` null: each point by
  /// itself; else with the volume strain of its cell and its pressure relaxed.
  void update_stress(Points &, const Step &, const CellMeans *means, Share &, PointRange);

  /// Move some points and check where they are.
  void move(Points &, const Moving &by, const Step &, Share &, PointRange);
} // namespace solid
