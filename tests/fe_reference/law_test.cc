// Kinematics, return mapping and their derivatives at one point.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "fe_reference/material_tangent.h"

namespace
{
  using fe::Matrix2;
  using fe::Matrix4;
  using fe::Vector4;

  Matrix2 matrix(const double a, const double b, const double c, const double d)
  {
    Matrix2 m;
    m << a, b, c, d;
    return m;
  }

  Matrix2 rotation(const double angle)
  {
    return matrix(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
  }

  // Central difference of `f` along l: f((1 + h l) x) in each of the four components of l.
  template <class Function>
  Matrix4 difference(const Function &function, const Matrix2 &f)
  {
    constexpr double h = 1e-6;
    Matrix4 result;
    for (int k = 0; k < 4; ++k)
    {
      Matrix2 l = Matrix2::Zero();
      l(k / 2, k % 2) = h;
      result.col(k) =
          (function((Matrix2::Identity() + l) * f) - function((Matrix2::Identity() - l) * f)) /
          (2. * h);
    }
    return result;
  }

  fe::Material plastic()
  {
    fe::Material material = fe::make_material(200., 0.3);
    material.yield_stress = 0.4;
    return material;
  }
} // namespace

TEST(PolarDecomposition, GivesBackRotationAndStretch)
{
  // f = V R with known V (principal stretches 1.2 and 0.9 at 0.4 rad) and R = 0.7 rad.
  const Matrix2 axes = rotation(0.4);
  const Matrix2 V = axes * matrix(1.2, 0., 0., 0.9) * axes.transpose();
  const fe::Increment increment = fe::decompose(V * rotation(0.7));
  EXPECT_NEAR(increment.angle, 0.7, 1e-14);
  const Matrix2 log = axes * matrix(std::log(1.2), 0., 0., std::log(0.9)) * axes.transpose();
  EXPECT_NEAR(increment.stretch[fe::xx], log(0, 0), 1e-14);
  EXPECT_NEAR(increment.stretch[fe::yy], log(1, 1), 1e-14);
  EXPECT_NEAR(increment.stretch[fe::xy], log(0, 1), 1e-14);
  EXPECT_EQ(increment.stretch[fe::zz], 0.);
}

TEST(PolarDecomposition, SeesNoStrainInALargeRotation)
{
  const fe::Increment increment = fe::decompose(rotation(2.9));
  EXPECT_NEAR(increment.angle, 2.9, 1e-14);
  EXPECT_LT(increment.stretch.norm(), 1e-15);
}

TEST(PolarDecomposition, DerivativesMatchDifferences)
{
  for (const Matrix2 &f : {matrix(1.02, 0.05, -0.01, 0.99), matrix(1.5, 0.4, -0.6, 0.8),
                           matrix(1. + 1e-9, 0., 0., 1.)})
  {
    const fe::Increment increment = fe::decompose(f);
    const Matrix4 stretch =
        difference([](const Matrix2 &g) { return fe::decompose(g).stretch; }, f);
    EXPECT_LT((increment.stretch_derivative - stretch).norm(), 1e-8);
    const Matrix4 angle =
        difference([](const Matrix2 &g) { return Vector4(fe::decompose(g).angle, 0., 0., 0.); }, f);
    EXPECT_LT((increment.angle_derivative.transpose() - angle.row(0)).norm(), 1e-8);
  }
}

TEST(RadialReturn, LeavesElasticStateBelowYield)
{
  const Vector4 trial(0.1, -0.1, 0.05, 0.1);
  const fe::ReturnMappingResult returned = fe::return_to_yield(plastic(), trial, 1.);
  EXPECT_EQ(returned.plastic_increment, 0.);
  EXPECT_EQ((returned.stress - trial).norm(), 0.);
}

TEST(RadialReturn, EndsOnTheYieldSurfaceAndKeepsPressure)
{
  const Vector4 trial(3., -1., 0.5, 2.);
  const fe::ReturnMappingResult returned = fe::return_to_yield(plastic(), trial, 1.);
  EXPECT_NEAR(fe::von_mises(returned.stress), 0.4, 1e-15);
  EXPECT_NEAR(returned.stress.head<3>().sum(), trial.head<3>().sum(), 1e-14);
}

TEST(PerzynaReturn, OverstressIsViscosityTimesRate)
{
  fe::Material material = plastic();
  material.viscosity = 3.;
  const double dt = 0.02;
  const fe::ReturnMappingResult returned =
      fe::return_to_yield(material, Vector4(3., -1., 0.5, 2.), dt);
  // Eq. (6) at the end of the step: q = sigma_Y + eta dgamma/dt.
  EXPECT_NEAR(fe::von_mises(returned.stress), 0.4 + 3. * returned.plastic_increment / dt, 1e-13);
}

TEST(Law, TangentMatchesDifferences)
{
  fe::Material viscous = plastic();
  viscous.viscosity = 0.5;
  fe::Material elastic = plastic();
  elastic.yield_stress.reset();
  const Vector4 old(0.1, -0.2, 0.05, 0.15);
  for (const fe::Material &material : {plastic(), viscous, elastic})
    for (const Matrix2 &f : {matrix(1.01, 0.03, -0.02, 0.995), matrix(1.2, 0.5, -0.3, 0.9)})
    {
      const auto stress = [&](const Matrix2 &g)
      { return fe::update_stress(material, old, g, 0.1).stress; };
      const Matrix4 tangent = fe::update_stress(material, old, f, 0.1).derivative;
      EXPECT_LT((tangent - difference(stress, f)).norm(), 1e-7 * (1. + tangent.norm()));
    }
}

TEST(Law, TurnsStressWithARigidRotation)
{
  // Ten turns in 80 increments of 45 degrees bring the stress back to itself.
  const Vector4 start(0.3, -0.1, 0.05, 0.1);
  Vector4 stress = start;
  double plastic_increment = 0.;
  for (int k = 0; k < 80; ++k)
  {
    const fe::LawResult result = fe::update_stress(plastic(), stress, rotation(M_PI / 4.), 1.);
    stress = result.stress;
    plastic_increment += result.plastic_increment;
  }
  EXPECT_LT((stress - start).norm(), 1e-13);
  EXPECT_EQ(plastic_increment, 0.);
}

TEST(Law, SimpleShearConvergesToJaumannAtSecondOrder)
{
  // Jaumann rate in simple shear: sigma_xy = G sin(gamma), sigma_xx = G (1 - cos gamma).
  fe::Material material = fe::make_material(200., 0.3);
  const double gamma = 1.5, G = material.shear_modulus;
  const auto error = [&](const int steps)
  {
    Vector4 stress = Vector4::Zero();
    // x = X + gamma Y, so one step multiplies F by 1 + (gamma/steps) e_x e_y.
    for (int k = 0; k < steps; ++k)
      stress = fe::update_stress(material, stress, matrix(1., gamma / steps, 0., 1.), 1.).stress;
    return Vector4(stress -
                   G * Vector4(1. - std::cos(gamma), std::cos(gamma) - 1., 0., std::sin(gamma)))
               .norm() /
           G;
  };
  const double coarse = error(20), fine = error(40);
  EXPECT_LT(fine, 2e-4);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}

TEST(Law, PerfectlyPlasticShearFlowsAtYieldOverRootThree)
{
  fe::Material material = plastic();
  Vector4 stress = Vector4::Zero();
  for (int k = 0; k < 400; ++k)
    stress = fe::update_stress(material, stress, matrix(1., 1e-4, 0., 1.), 1.).stress;
  EXPECT_NEAR(stress[fe::xy], 0.4 / std::sqrt(3.), 1e-5);
  EXPECT_NEAR(fe::von_mises(stress), 0.4, 1e-14);
}
