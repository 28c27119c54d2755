#include "return_mapping.h"

#include <cmath>

namespace fe
{
  namespace
  {
    double mean_stress(const Vector4 &stress)
    {
      return (stress[xx] + stress[yy] + stress[zz]) / 3.;
    }

    Vector4 deviator(const Vector4 &stress)
    {
      const double p = mean_stress(stress);
      return {stress[xx] - p, stress[yy] - p, stress[zz] - p, stress[xy]};
    }

    double norm_squared(const Vector4 &s)
    {
      return s[xx] * s[xx] + s[yy] * s[yy] + s[zz] * s[zz] + 2. * s[xy] * s[xy];
    }
  } // namespace

  Material make_material(const double young_modulus, const double poisson_ratio)
  {
    Material material;
    material.shear_modulus = young_modulus / (2. * (1. + poisson_ratio));
    material.lame =
        young_modulus * poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
    return material;
  }

  double von_mises(const Vector4 &stress)
  {
    return std::sqrt(1.5 * norm_squared(deviator(stress)));
  }

  Vector4 elastic_stress(const Material &material, const Vector4 &strain)
  {
    // Hooke's law for the elastic part, isotropic; the paper gives it no number (Sec. 2.2).
    const double pressure = material.lame * (strain[xx] + strain[yy] + strain[zz]);
    return 2. * material.shear_modulus * strain + Vector4(pressure, pressure, pressure, 0.);
  }

  double elastic_energy(const Material &material, const Vector4 &stress)
  {
    const double p = mean_stress(stress);
    const double bulk = material.lame + 2. / 3. * material.shear_modulus;
    return norm_squared(deviator(stress)) / (4. * material.shear_modulus) + p * p / (2. * bulk);
  }

  ReturnMappingResult return_to_yield(const Material &material, const Vector4 &trial,
                                      const double dt)
  {
    ReturnMappingResult result;
    result.stress = trial;
    if (!material.yield_stress)
      return result;
    const Vector4 s = deviator(trial);
    const double q = std::sqrt(1.5 * norm_squared(s));
    const double f = q - *material.yield_stress; // f_Y of Eq. (6)
    if (f <= 0.)
      return result;

    const double three_g = 3. * material.shear_modulus;
    const double stiffness = three_g + (material.viscosity > 0. ? material.viscosity / dt : 0.);
    result.plastic_increment = f / stiffness; // gamma dt of Eq. (6), backward Euler
    const double shrink = 1. - three_g * result.plastic_increment / q;
    const double p = mean_stress(trial);
    result.stress = shrink * s + Vector4(p, p, p, 0.); // Eq. (5): along s

    // ds = shrink ds_trial + s_trial dshrink,  dq = (3/2) s : ds_trial / q.
    const double dshrink = three_g / q * (result.plastic_increment / q - 1. / stiffness);
    const Vector4 dq = 1.5 / q * Vector4(s[xx], s[yy], s[zz], 2. * s[xy]);
    Matrix4 projector = Matrix4::Identity();
    projector.topLeftCorner<3, 3>().array() -= 1. / 3.;
    result.derivative = Matrix4::Identity() - (1. - shrink) * projector;
    result.derivative += dshrink * s * dq.transpose();
    return result;
  }
} // namespace fe
