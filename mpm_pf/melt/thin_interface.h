// What the phase-field parameters of Eq. (1) mean physically, by the thin-interface relations of
// scene/thin_interface.h: lambda follows from d0/W0. Kinetics-free growth, beta = 0, then fixes D
// tau0/W0^2 = a2 lambda: one number of d0, W0, tau0, D is not free, and a scene that gives all four
// inconsistently is refused. The paper's d0/W0 = 0.185 and D tau0/W0^2 = 3 agree to 0.2 %.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/thin_interface.h"

namespace melt
{
  using scene::a1, scene::a2, scene::coupling_constant;

  /// The numbers of Eqs. (1) and (2), in the scene's units.
  struct Law
  {
    double width = 1.;       // W0, length
    double relaxation = 1.;  // tau0, time
    double anisotropy = 0.;  // eps
    double coupling = 0.;    // lambda; 0 where there is no heat
    double diffusivity = 0.; // D, length^2/time
  };

  /// Why an interface of this width is no thin one beside the capillary length, as a sentence with
  /// numbers and remedy; empty up to W0 = 8 d0. Karma and Rappel (1998) follow their relations to
  /// 7.2 d0 (D tau0/W0^2 = 4); beyond, tips are slower than sharp ones with nothing else to show
  /// it.
  std::string width_warning(double capillary_length, double width);

  /// The same for a mesh that cannot hold the profile: below W0 = dx/2 phi is a step from node to
  /// node, and its contour stands wherever between them; a front that grows is pinned to the nodes
  /// below W0 = dx already.
  std::string profile_warning(double width, double spacing, bool grows);

  /// The law of a scene's sections, which the scene's rules have found well-posed and consistent;
  /// `heat` may be null (growth by curvature alone, lambda = 0).
  Law make_law(const scene::PhaseField &, const scene::Growth &, const scene::Heat *heat);
} // namespace melt
