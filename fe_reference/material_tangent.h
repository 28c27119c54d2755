// The law at one integration point: stress after a load increment and its spatial derivative.
//
// Cauchy stress, hypoelastic with the Jaumann rate, J2 flow: rotate and strain (kinematics.h),
// return to the yield surface (return_mapping.h). The derivative is with respect to the spatial
// gradient l of the displacement increment, d sigma / dl, a 4x4 matrix: rows xx, yy, zz, xy,
// columns l11, l12, l21, l22. It holds the rotation of the old stress as well and is therefore not
// symmetric; it is the exact derivative of the discrete update, not of the rate equation.
#pragma once

#include "return_mapping.h"

namespace fe
{
  /// What an integration point remembers between load steps.
  struct PointState
  {
    Vector4 stress = Vector4::Zero(); // Cauchy: xx, yy, zz, xy
    double plastic_strain = 0.;       // equivalent
    double plastic_work = 0.;         // per initial volume
    Matrix2 F =
        Matrix2::Identity(); // deformation gradient that the law has seen (dilated, see element.h)
  };

  struct LawResult
  {
    Vector4 stress = Vector4::Zero();
    double plastic_increment = 0.;
    Matrix4 derivative = Matrix4::Zero(); // d stress / dl
  };

  /// Stress after the relative deformation `f` (det f > 0) of a point with stress `old_stress`
  /// over the time `dt`.
  LawResult update_stress(const Material &, const Vector4 &old_stress, const Matrix2 &f, double dt);
} // namespace fe
