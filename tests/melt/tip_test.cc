#include "melt/tip.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "seed.h"

namespace
{
  using test::Boundary;
  using test::Field;
  using test::Mesh;
  using test::Point;

  Field<double> disc(const Mesh &mesh, const Point &centre, double radius)
  {
    return test::seeded(mesh, centre, radius, 0.).phi;
  }
} // namespace

TEST(Tip, OfADiscLiesOnItsCircleFromAnyDirection)
{
  const Mesh mesh = test::square_mesh(61, 0.4, Boundary::no_flux);
  const Point centre{12.1, 11.8};
  const Field<double> phi = disc(mesh, centre, 6.);
  for (const double angle : {0., 0.3, M_PI / 4., 2.5})
  {
    const auto tip = melt::find_tip(phi, mesh, {centre, {std::cos(angle), std::sin(angle)}}, 1.);
    ASSERT_TRUE(tip);
    EXPECT_NEAR(tip->position, 6., 0.01);
    EXPECT_NEAR(tip->radius, 6., 0.2);
    EXPECT_GE(tip->crossings, 8); // three more than the fit has coefficients
    EXPECT_LT(tip->residual, 0.05);
  }
}

// In metres a crystal of nanometres has terms of 1e-27 beside others of 1e-9.
TEST(Tip, IsTheSameInAnyUnitOfLength)
{
  constexpr double nano = 1e-9;
  const Mesh mesh = test::square_mesh(61, 0.4, Boundary::no_flux);
  const Mesh in_metres = test::square_mesh(61, 0.4 * nano, Boundary::no_flux);
  const Point centre{12.1, 11.8};
  const Field<double> phi = disc(mesh, centre, 6.);
  Field<double> same(in_metres);
  for (int j = 0; j < mesh.nodes[1]; ++j)
    for (int i = 0; i < mesh.nodes[0]; ++i)
      same(i, j) = phi(i, j);
  const auto expected = melt::find_tip(phi, mesh, {centre, {1., 0.3}}, 1.);
  const auto found = melt::find_tip(same, in_metres, {nano * centre, {1., 0.3}}, nano);
  ASSERT_TRUE(expected && found);
  EXPECT_NEAR(found->position / nano, expected->position, 1e-10);
  EXPECT_NEAR(found->radius / nano, expected->radius, 1e-8);
  EXPECT_NEAR(found->residual / nano, expected->residual, 1e-8);
}

TEST(Tip, OnASymmetryWallUsesTheMirrorImage)
{
  const Mesh mesh = test::square_mesh(61, 0.4, Boundary::symmetry);
  const Field<double> phi = disc(mesh, {0., 0.}, 9.);
  const auto tip = melt::find_tip(phi, mesh, {{0., 0.}, {1., 0.}}, 1.);
  ASSERT_TRUE(tip);
  EXPECT_NEAR(tip->position, 9., 0.01);
  EXPECT_NEAR(tip->radius, 9., 0.3);
}

TEST(Tip, RadiusConvergesOnASharpParabola)
{
  // psi is the exact distance-like function x_tip - x - y^2/(2 rho), divided by its slope.
  double coarse = 0.;
  for (const double spacing : {0.4, 0.2})
  {
    const Mesh mesh =
        test::square_mesh(static_cast<int>(24. / spacing) + 1, spacing, Boundary::symmetry);
    Field<double> phi(mesh);
    const double rho = 1.15;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const Point x = mesh.position(i, j);
        phi(i, j) = std::tanh((12.3 - x[0] - x[1] * x[1] / (2. * rho)) /
                              std::hypot(1., x[1] / rho) / std::sqrt(2.));
      }
    const auto tip = melt::find_tip(phi, mesh, {{0., 0.}, {1., 0.}}, 1.);
    ASSERT_TRUE(tip);
    const double error = std::abs(tip->radius / rho - 1.);
    EXPECT_LT(error, 0.06);
    coarse = std::max(coarse, error);
    EXPECT_LE(error, coarse);
  }
}

TEST(Tip, ResidualTellsASmoothTipFromAKinkedOne)
{
  const Mesh mesh = test::square_mesh(61, 0.4, Boundary::symmetry);
  const auto residual = [&](auto depth) // of the front behind the tip, from the distance aside
  {
    Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const Point x = mesh.position(i, j);
        phi(i, j) = std::tanh((12.3 - x[0] - depth(x[1])) / std::sqrt(2.));
      }
    return melt::find_tip(phi, mesh, {{0., 0.}, {1., 0.}}, 1.)->residual;
  };
  const double smooth = residual([](double y) { return y * y / 2.3; }),
               kinked = residual([](double y) { return std::abs(y) / 2.; });
  EXPECT_LT(smooth, 2e-3);
  EXPECT_GT(kinked, 5. * smooth);
}

TEST(Tip, IsAbsentWithoutSolidOrWithoutLiquidAhead)
{
  const Mesh mesh = test::square_mesh(31, 0.4, Boundary::no_flux);
  EXPECT_FALSE(melt::find_tip(Field<double>(mesh, -1.), mesh, {{6., 6.}, {1., 0.}}, 1.));
  EXPECT_FALSE(melt::find_tip(Field<double>(mesh, 1.), mesh, {{6., 6.}, {1., 0.}}, 1.));
  EXPECT_THROW(melt::find_tip(Field<double>(mesh, 1.), mesh, {{-6., 6.}, {1., 0.}}, 1.),
               std::invalid_argument);
  EXPECT_THROW(melt::find_tip(Field<double>(mesh, 1.), mesh, {{6., 6.}, {0., 0.}}, 1.),
               std::invalid_argument);
}

TEST(TipVelocity, IsTheSlopeOverTheWindowAndForgetsTheStart)
{
  melt::TipTrack track;
  for (int k = 0; k <= 400; ++k)
  {
    const double t = 0.1 * k;
    const double x = t < 20. ? 5. * t : 100. + 0.3 * (t - 20.); // slow after a fast start
    melt::add_sample(track, t, x + 1e-3 * (k % 2), 4.);
  }
  const melt::TipVelocity velocity = melt::tip_velocity(track, 4.);
  EXPECT_NEAR(velocity.value, 0.3, 1e-4);
  EXPECT_NEAR(velocity.residual, 5e-4, 1e-4);
  EXPECT_GE(velocity.travel, 4.);
  EXPECT_LT(track.time.size(), 180u);
  EXPECT_TRUE(std::isnan(melt::tip_velocity(melt::TipTrack{}, 4.).value));
}

TEST(Resolution, IsJudgedByTipRadiusAgainstSpacingAndWidth)
{
  const Mesh mesh = test::square_mesh(31, 0.4, Boundary::no_flux);
  EXPECT_EQ(melt::resolution_warning(1.15, mesh, 1.), ""); // eps = 0.05
  EXPECT_NE(melt::resolution_warning(0.384, mesh, 1.).find("under-resolved"), std::string::npos);
  const Mesh fine = test::square_mesh(31, 0.1, Boundary::no_flux);
  EXPECT_NE(melt::resolution_warning(0.384, fine, 1.).find("W0"), std::string::npos);
}
