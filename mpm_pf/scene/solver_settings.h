// How each solver of the mechanics is to work; each reads its own section and skips the other's.
#pragma once

#include <array>
#include <optional>

#include "scene/domain.h"

namespace scene
{
  struct Clock
  {
    double end = 0.;
    std::optional<double> step; // coupling step of a coupled scene
    SourceLocation place;
  };

  enum class ShapeFunction
  {
    quadratic_bspline,
    ugimp,
    linear
  };
  enum class Transfer
  {
    tpic,
    apic,
    flip,
    pic,
    xpic2
  };
  enum class StressUpdate
  {
    last,
    first
  };

  /// The material points, read by mpm_pf only.
  struct Mpm
  {
    std::array<int, 2> points_per_cell{2, 2};
    ShapeFunction shape_function = ShapeFunction::quadratic_bspline;
    Transfer transfer = Transfer::tpic;
    double flip_fraction = 0.99; // of transfer = flip
    StressUpdate stress_update = StressUpdate::last;
    std::optional<bool> anti_locking;      // empty: on for solids that lock
    double pressure_relaxation = 0.1;      // towards the cell mean, per step
    double step_fraction = 0.4;            // of dx/(c_p + |v|)
    double node_mass_floor = 0.1;          // of a full cell's mass
    std::optional<double> mach;            // wanted V/c_p: density is scaled to it
    std::optional<double> reference_speed; // V; default: largest speed of supports and walls
    bool split_points = false;
    SourceLocation place;
  };

  /// The finite elements, read by fe_reference only.
  struct Fe
  {
    std::array<int, 2> cells{
        0, 0}; // over the bounding box of the bodies; 0: choose from domain spacing
    int degree = 2;
    int load_steps = 100;
    double tolerance = 1e-9;
    double grading = 0.; // 0: uniform; towards 1: finer near clamped corners
    bool past_folding = false;
    SourceLocation place;
  };
} // namespace scene
