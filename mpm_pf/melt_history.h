// Scalar diagnostics of the melt's fields, the melt's part of a history probe.
#pragma once

#include <string>
#include <vector>

#include "world.h"

struct HistoryColumns
{
  std::vector<std::string> names, units;
  std::vector<double> values;
  void add(const std::string &name, const std::string &unit, double value);
};

/// The phi = 0 contour, between the walls where there are any.
std::vector<scene::Polyline> phase_contour(const World &);

/// With phi: solid_area, interface_length, interface_width (mean of 1/(sqrt(2)|grad phi|) along the
/// contour), phi_min, phi_max, active_tiles. With theta: theta_mean, theta_variance, theta_min,
/// theta_max, heat_content (integral of theta - phi/2), all over what the walls have left of the
/// domain. Where something moves them also carried_heat and carried_phase, what advection has added
/// to the integrals of theta and phi: v . grad of Eqs. (1) and (2) is no flux. Between adiabatic
/// sides and walls
///   heat_content + swept_heat - swept_phase/2 - (carried_heat - carried_phase/2)
/// is constant to rounding; what walls sweep is recorded beside their positions. On a square mesh
/// diagonal_defect, the largest |phi(x, y) - phi(y, x)|.
HistoryColumns melt_history(const World &);
