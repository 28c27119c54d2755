// Walls as whoever moves them sees them: plain data in, reactions out.
#pragma once

#include <vector>

#include "solid/solid.h"

namespace solid
{
  /// A wall of the scene at the end of the coming call of advance, and its mean velocity over it.
  struct WallMotion
  {
    scene::Edge side;
    double position; // coordinate across the wall, length
    double velocity; // along the axis, not inward
  };

  /// Walls move from position - velocity dt to position during the coming advance(solid, dt). To be
  /// called before every advance of a scene with walls. Throws std::out_of_range for a side on
  /// which the scene has no wall.
  void set_wall_motions(Solid &, const std::vector<WallMotion> &, double dt);

  /// Name of its reaction: "wall left", "wall right", "wall bottom" or "wall top".
  std::string wall_name(scene::Edge);

  /// Is the loading quasi-static? Each number small means yes.
  struct QuasiStatic
  {
    /// Travel of a wall until inertia alone has brought the material to its speed with one yield
    /// stress: arm rho V^2/sigma_Y, length. Without yield stress: with the stress that compresses
    /// by 1 %.
    double inertia_travel = 0.;
    /// |F_1 + F_2| over the mean of |F_1| and |F_2| of opposite walls, means of the last call.
    double force_imbalance = 0.;
    /// Mean of |dP/dt| over the mean of |F| since a wall first pressed, P the momentum of the solid
    /// and F the force of a wall that has none opposite. What F does not spend on P goes through
    /// the symmetry side: 0 in equilibrium, 1 in free flight.
    double momentum_to_force = 0.;
    double kinetic_to_internal = 0.; // kinetic energy over elastic energy and plastic dissipation
  };

  struct WallLoading
  {
    double arm = 0.;   // length of material that the wall has to stop or move
    double speed = 0.; // of the wall
  };
  /// The imbalance is that of walls on opposite sides, else 0; momentum over force is that of walls
  /// that have none opposite, else 0.
  QuasiStatic quasi_static(const Solid &, const WallLoading &);
} // namespace solid
