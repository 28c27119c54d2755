// The growing crystal, Eqs. (1)-(3), and what moves it: each struct is one section of the scene.
#pragma once

#include <cstdint>
#include <optional>

#include "scene/domain.h"

namespace scene
{
  struct PhaseField
  {
    double width = 1.;
    SourceLocation place;
  }; // W0; alone: a passive marker of the bodies
  enum class Laplacian
  {
    five_point,
    nine_point
  };
  enum class Precision
  {
    double_precision,
    single_precision
  };
  struct Growth
  {
    double anisotropy = 0.05;
    double capillary_length = 0.185;           // d0
    double relaxation_time = 1.;               // tau0
    std::optional<double> kinetic_coefficient; // empty: kinetics-free
    Laplacian laplacian = Laplacian::nine_point;
    Precision precision = Precision::double_precision;
    double step_fraction = 0.8; // of the explicit limit
    std::optional<double> step; // explicit growth step instead
    bool tiles = true;
    SourceLocation place;
  };
  struct Heat
  {
    double diffusivity = 3.;
    double undercooling = 0.55;
    std::optional<Expression> initial;
    SourceLocation place;
  };
  struct Orientation
  {
    double angle_degrees = 0.;
    bool turning = true;
    SourceLocation place;
  };
  struct Noise
  {
    double strength = 0.;
    std::uint64_t seed = 1;
    bool mirrored = false;
    SourceLocation place;
  };
  /// Imposed motion instead of a solid: velocity of x, y, t over the whole domain.
  struct Imposed
  {
    VectorExpression velocity;
    SourceLocation place;
  };
  enum class AdvectionScheme
  {
    cip,
    cip_hermite,
    weno5,
    upwind
  };
  struct Advection
  {
    AdvectionScheme scheme = AdvectionScheme::cip;
    double step_fraction = 0.2;
    int interval = 1; // coupling steps from one advection to the next
    bool analytic_gradients = true;
    SourceLocation place;
  };
  enum class ExtensionMethod
  {
    closest_point,
    pde
  };
  struct Extension
  {
    ExtensionMethod method = ExtensionMethod::closest_point;
    double band = 12.;
    int interval = 1;      // extensions from one measurement of the distance to the next
    int map_interval = 20; // and from one update of the whole mesh to the next
    SourceLocation place;
  };
} // namespace scene
