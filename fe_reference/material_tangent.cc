#include "material_tangent.h"

namespace fe
{
  LawResult update_stress(const Material &material, const Vector4 &old_stress, const Matrix2 &f,
                          const double dt)
  {
    const Increment increment = decompose(f);
    const Vector4 rotated = rotate(old_stress, increment.angle);
    const Vector4 trial = rotated + elastic_stress(material, increment.stretch); // Hooke
    const ReturnMappingResult returned = return_to_yield(material, trial, dt);

    Matrix4 derivative = 2. * material.shear_modulus * increment.stretch_derivative;
    const Eigen::RowVector4d dilation =
        material.lame * increment.stretch_derivative.colwise().sum() -
        material.lame * increment.stretch_derivative.row(xy);
    for (const int normal : {xx, yy, zz})
      derivative.row(normal) += dilation;
    derivative += rotation_derivative(rotated) * increment.angle_derivative.transpose();

    LawResult result;
    result.stress = returned.stress;
    result.plastic_increment = returned.plastic_increment;
    result.derivative =
        returned.plastic_increment > 0. ? Matrix4(returned.derivative * derivative) : derivative;
    return result;
  }
} // namespace fe
