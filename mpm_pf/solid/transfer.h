// Between points and nodes, one pass each way a step.
//
// Points to nodes: m_i = sum w m,  p_i = sum w m (v_p + C_p (x_i - x_p)),  f_i = sum (w m b - V
// sigma grad w). Nodes to points, the default TPIC: v_p = sum w v_i, C_p = sum v_i grad w: momentum
// is kept, a linear field passes unchanged, and with it its angular momentum (of a beam that swings
// as it spins 0.08 % are lost), and no velocity that the grid cannot see survives (FLIP keeps it:
// its noise tears a plastic bar on fine grids). Also
//   APIC   C_p = (sum w v_i d) / (sum w d^2) a direction (Jiang et al. 2015)
//   FLIP   v_p = f (v_p + sum w dv_i) + (1 - f) sum w v_i, C_p = 0;  PIC is f = 0
//   XPIC2  v_p = 2 S v* - S S+ S v* + S dv, v* = S+ v_p the transferred velocity before forces
//          (Hammerquist & Nairn 2017, order 2)
// The velocity gradient of the new grid velocity goes to the stress update (update stress last).
//
// Last is not neutral for FLIP. Per step the stresses see v_i + dv_i, but the points, and so the
// nodes of the next step, only dv_i as the points pass it on: P S dv, P and S to nodes and to
// points. Summed up, energy changes by
//   -1/2 (sum m_i dv_i^2 - sum m_p (S dv)_p^2) < 0,
// an amount in proportion to the step that is not physical: two discs on 20 x 20 cells lose 13 % of
// their energy with 0.4 of the largest step, 3 % with 0.02. Stresses updated *first*, with the
// velocities that the points bring, see only P S dv, and the step is then that of the symplectic
// Euler method with the mass matrix (P S M^-1)^-1: no drift (Bardenhagen 2002 measured the same).
// It takes a second pass each way.
#pragma once

#include "solid/grid.h"
#include "solid/shape_functions.h"

namespace solid
{
  using Transfer = scene::Transfer;

  /// Everything about the method that does not change during a run.
  struct Scheme
  {
    Shape shape = Shape::quadratic_bspline;
    Transfer transfer = Transfer::tpic;
    double flip_fraction = 0.99;
    std::array<double, 2> half_size{0.25, 0.25}; // of a point in cells, for uGIMP
    bool stress_first = false;
    bool anti_locking = false;
    double pressure_relaxation = 0.1;
    double step_fraction = 0.4;
    double node_mass_floor = 0.1; // of a full cell's mass, see light_nodes.h; 0: off

    bool affine() const { return transfer == Transfer::tpic || transfer == Transfer::apic; }
    bool incremental() const { return transfer == Transfer::flip || transfer == Transfer::xpic2; }
  };

  /// The lines near which shape functions are folded; grid.fold is 1 + index into `pairs`.
  struct FoldTable
  {
    std::vector<Fold> lines;
    std::vector<std::array<int, 2>> pairs; // line across x, line across y; -1: none
  };

  /// What gives a place its shape functions, all of it as it is during one step.
  struct Interpolation
  {
    const Scheme &scheme;
    const Grid &grid;
    const FoldTable &folds;
  };

  /// Weights of a point in both directions and the column and row of its centre node.
  struct Stencil
  {
    Weights x, y;
    int i, j;
  };
  /// For anything that lies near material: points, tracers, loads. Folded where the grid says so.
  Stencil stencil(const Interpolation &, const Point &);

  /// Acceleration by body forces: uniform, or one value a point.
  struct Acceleration
  {
    Point uniform = Point::Zero();
    Array<double> x, y; // empty: uniform
    Point at(const std::size_t p) const { return x.empty() ? uniform : Point(x[p], y[p]); }
  };

  /// What Eq. (4) takes from the points: mass and momentum, and as forces their stresses over the
  /// volume that mass and jacobian tell, and the body force.
  struct MomentumSource
  {
    const Points &points;
    const Acceleration &acceleration;
    double inverse_density;
  };

  /// Add mass, momentum and force of some points to their nodes of `grid`, that of the
  /// interpolation.
  void scatter(const Interpolation &, const MomentumSource &, Grid &grid, PointRange);

  /// Room for the velocities that move a range of points, in flip and xpic not their own.
  struct Moving
  {
    double *vx = nullptr, *vy = nullptr; // that of the first point first; null: their own
  };

  /// Velocity and velocity gradient of some points from the nodes.
  void gather(const Interpolation &, Points &, const Moving &, PointRange);

  /// Their velocity gradient only.
  void gather_gradient(const Interpolation &, Points &, PointRange);

  /// APIC's affine part in place of the velocity gradient, once the stress update is done with it.
  void gather_affine(const Interpolation &, Points &, PointRange);

  /// XPIC(2): v_p = 2 S v* - S S+ S v* for all points, before the change by forces is added.
  /// Serial.
  void smooth_velocity(const Interpolation &, Points &);
} // namespace solid
