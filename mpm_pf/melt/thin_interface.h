// What the phase-field parameters of Eq. (1) mean physically: Karma and Rappel's thin-interface
// relations (Phys. Rev. E 57, 4323, 1998), for p'(phi) = (1 - phi^2)^2:
//
//   d0 = a1 W0 / lambda,   beta = a1 (tau0/(lambda W0) - a2 W0/D),   a1 = 5 sqrt(2)/8, a2 = 0.6267.
//
// lambda follows from d0/W0. Kinetics-free growth, beta = 0, then fixes D tau0/W0^2 = a2 lambda:
// one number of d0, W0, tau0, D is not free, and a scene that gives all four inconsistently is
// refused. The paper's d0/W0 = 0.185 and D tau0/W0^2 = 3 agree to 0.2 %.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace melt
{
  inline constexpr double a1 = 0.88388347648318447; // 5 sqrt(2)/8
  inline constexpr double a2 = 0.6267;

  /// The numbers of Eqs. (1) and (2), in the scene's units.
  struct Law
  {
    double width = 1.;       // W0, length
    double relaxation = 1.;  // tau0, time
    double anisotropy = 0.;  // eps
    double coupling = 0.;    // lambda; 0 where there is no heat
    double diffusivity = 0.; // D, length^2/time
  };

  /// lambda = a1 W0/d0.
  double coupling_constant(double capillary_length, double width);
  /// beta, time per length; zero is kinetics-free growth.
  double kinetic_coefficient(const Law &);

  /// Why an interface of this width is no thin one beside the capillary length, as a sentence with
  /// numbers and remedy; empty up to W0 = 8 d0. Karma and Rappel (1998) follow their relations to
  /// 7.2 d0 (D tau0/W0^2 = 4); beyond, tips are slower than sharp ones with nothing else to show
  /// it.
  std::string width_warning(double capillary_length, double width);

  /// The same for a mesh that cannot hold the profile: below W0 = dx/2 phi is a step from node to
  /// node, and its contour stands wherever between them; a front that grows is pinned to the nodes
  /// below W0 = dx already.
  std::string profile_warning(double width, double spacing, bool grows);

  /// The law of a scene's sections; `heat` may be null (growth by curvature alone, lambda = 0).
  /// Throws scene::BadScene where anisotropy >= 1/15 (the interface stiffness 1 - 15 eps is
  /// negative: Eq. (1) is ill-posed), where the asked kinetic coefficient (default zero) differs
  /// from the one that the other numbers give by more than 2 % of the diffusive term a1 a2 W0/D,
  /// naming the relaxation time that would agree.
  Law make_law(const scene::PhaseField &, const scene::Growth &, const scene::Heat *heat);
} // namespace melt
