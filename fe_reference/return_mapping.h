// J2 plasticity without hardening, rate-independent or Perzyna: the closest-point return of a
// trial stress and its exact derivative.
//
// With f = q - sigma_Y and q = sqrt(3/2 s:s), the flow of Eqs. (5) and (6),
//     d eps^vp/dt = (<f>/eta) df/dsigma,
// is integrated by backward Euler over dt. Flow is radial, so the deviator only shrinks and the
// equation for the equivalent plastic increment is linear:
//     dgamma = f_trial / (3 G + eta/dt),   s = (1 - 3 G dgamma / q_trial) s_trial.
// Without viscosity (eta = 0) this is the rate-independent radial return: q = sigma_Y exactly.
// Stress and strain keep zz; the four numbers are xx, yy, zz, xy. The consistent tangent is the
// derivative of this very update, so Newton's iterations converge quadratically.
// Source: J. C. Simo and T. J. R. Hughes, Computational Inelasticity (1998), boxes 3.1 and 3.2.
#pragma once

#include <optional>

#include "kinematics.h"

namespace fe
{
  /// Elastic moduli [stress] and, if present, yield stress [stress] and viscosity [stress time].
  struct Material
  {
    double shear_modulus = 0., lame = 0.; // G and lambda
    std::optional<double> yield_stress;   // absent: elastic
    double viscosity = 0.;                // 0: rate-independent
    double density = 0.;                  // initial
  };

  /// Moduli from Young's modulus and Poisson's ratio.
  Material make_material(double young_modulus, double poisson_ratio);

  double von_mises(const Vector4 &stress);

  /// C : strain (tensor shear, not doubled).
  Vector4 elastic_stress(const Material &, const Vector4 &strain);

  /// Elastic energy per volume of a stress, sigma : C^-1 : sigma / 2.
  double elastic_energy(const Material &, const Vector4 &stress);

  struct ReturnMappingResult
  {
    Vector4 stress = Vector4::Zero();
    double plastic_increment = 0.;            // equivalent, >= 0
    Matrix4 derivative = Matrix4::Identity(); // d stress / d trial
  };

  /// Return `trial` to the yield surface (or towards it, for Perzyna, within the time `dt`).
  ReturnMappingResult return_to_yield(const Material &, const Vector4 &trial, double dt);
} // namespace fe
