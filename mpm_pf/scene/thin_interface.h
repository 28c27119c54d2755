// Thin-interface relations of the quartic double well in the plane (Karma and Rappel, Phys. Rev. E
// 57, 4323, 1998), for p'(phi) = (1 - phi^2)^2:
//
//   d0 = a1 W0 / lambda,   beta = a1 (tau0/(lambda W0) - a2 W0/D),   a1 = 5 sqrt(2)/8, a2 = 0.6267.
//
// They stand here because a scene that breaks them is refused when it is read.
#pragma once

namespace scene
{
  inline constexpr double a1 = 0.88388347648318447; // 5 sqrt(2)/8
  inline constexpr double a2 = 0.6267;

  /// The anisotropy at which the interface stiffness 1 - 15 eps vanishes: from it on orientations
  /// are missing and Eq. (1) is ill-posed.
  inline constexpr double ill_posed_anisotropy = 1. / 15.;

  /// lambda of the capillary length d0 and the interface width W0.
  inline double coupling_constant(const double capillary_length, const double width)
  {
    return a1 * width / capillary_length;
  }

  /// What beta depends on beside the constants: lambda, W0, tau0, D.
  struct Kinetics
  {
    double coupling, width, relaxation, diffusivity;
  };

  /// beta, time per length; zero is kinetics-free growth.
  inline double kinetic_coefficient(const Kinetics &k)
  {
    return a1 * (k.relaxation / (k.coupling * k.width) - a2 * k.width / k.diffusivity);
  }
} // namespace scene
