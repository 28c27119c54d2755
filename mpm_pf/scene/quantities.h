// Names of what a probe can ask for: the one list that both solvers and the comparisons use.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace scene
{
  /// Quantities of the solid, in the scene's units; stresses are Cauchy, angles in radians (CCW +).
  /// yielded: 1 where von Mises > 0.99 yield stress, so that its region mean is the yielded
  /// fraction.
  inline constexpr std::array<std::string_view, 16> solid_quantities{
      "von_mises", "plastic_strain", "pressure",       "stress_xx",  "stress_yy",  "stress_zz",
      "stress_xy", "displacement_x", "displacement_y", "velocity_x", "velocity_y", "jacobian",
      "yielded",   "log_strain_xx",  "log_strain_yy",  "area"};

  /// Quantities of the melt side; theta = (T - Tm)/(L/cp).
  inline constexpr std::array<std::string_view, 3> melt_quantities{"phi", "theta", "crystal_angle"};

  inline bool is_melt_quantity(const std::string_view name)
  {
    return std::find(melt_quantities.begin(), melt_quantities.end(), name) != melt_quantities.end();
  }

  /// Is it measured from where the material was at the start? Material that grew has its own start.
  inline bool needs_initial_position(const std::string_view quantity)
  {
    return quantity.substr(0, 10) == "log_strain";
  }
} // namespace scene
