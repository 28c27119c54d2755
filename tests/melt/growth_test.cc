#include "melt/growth.h"

#include <gtest/gtest.h>

#include "medium/numerical_error.h"
#include "medium/sums.h"
#include "melt/heat_budget.h"
#include "seed.h"

namespace
{
  using melt::Growth;
  using melt::GrowthOptions;
  using test::Boundary;
  using test::Field;
  using test::Mesh;

  /// Area of the solid from the mean of phi, in units of the spacing squared.
  double solid_area(const Field<double> &phi, const Mesh &mesh)
  {
    const double cells = (mesh.nodes[0] - 1.) * (mesh.nodes[1] - 1.);
    return 0.5 * (cells + medium::weighted_sum(phi, mesh));
  }

  /// Largest distance from tanh(x/(sqrt(2) W0)) of a front that was started twice as wide.
  double profile_error(int cells)
  {
    Mesh mesh = test::square_mesh(cells + 1, 20. / cells, Boundary::no_flux);
    mesh.nodes[1] = 5;
    Field<double> phi(mesh), exact(mesh);
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i <= cells; ++i)
      {
        const double x = mesh.position(i, j)[0] - 10.;
        phi(i, j) = std::tanh(x / std::sqrt(8.));
        exact(i, j) = std::tanh(x / std::sqrt(2.));
      }
    Growth growth(mesh, {1., 1., 0., 0., 0.}, GrowthOptions{}, 0.);
    const double h = growth.step_limit();
    growth.advance({&phi, nullptr, nullptr, nullptr}, h, static_cast<long>(20. / h));
    return test::largest_difference(phi, exact, mesh);
  }
} // namespace

TEST(Growth, PlanarFrontRelaxesToTheTanhProfileAtSecondOrder)
{
  const double coarse = profile_error(40), fine = profile_error(80);
  EXPECT_LT(fine, 0.01);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.2);
}

TEST(Growth, KeepsHeatMinusLatentHeatToRounding)
{
  for (const Boundary side : {Boundary::no_flux, Boundary::symmetry, Boundary::periodic})
    for (const auto laplacian : {scene::Laplacian::five_point, scene::Laplacian::nine_point})
    {
      const Mesh mesh = test::square_mesh(71, 0.4, side);
      test::Melt melt = test::seeded(mesh, {11., 12.}, 5., 0.55);
      GrowthOptions options;
      options.laplacian = laplacian;
      Growth growth(mesh, test::paper_law(0.05), options, 0.55);
      const double before = melt::heat_budget(melt.phi, melt.theta, mesh).total();
      const double area = solid_area(melt.phi, mesh);
      growth.advance(melt.fields(), 0.8 * growth.step_limit(), 1000);
      EXPECT_GT(solid_area(melt.phi, mesh), 1.5 * area);
      EXPECT_NEAR(melt::heat_budget(melt.phi, melt.theta, mesh).total() / before, 1., 1e-13);
    }
}

TEST(Growth, StaysFourFoldSymmetricAndMirrored)
{
  const Mesh mesh = test::square_mesh(101, 0.4, Boundary::no_flux);
  test::Melt melt = test::seeded(mesh, {20., 20.}, 4., 0.55);
  Growth growth(mesh, test::paper_law(0.05), GrowthOptions{}, 0.55);
  growth.advance(melt.fields(), 0.8 * growth.step_limit(), 1500);
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i)
    {
      ASSERT_NEAR(melt.phi(i, j), melt.phi(j, i), 1e-12);
      ASSERT_NEAR(melt.phi(i, j), melt.phi(100 - i, j), 1e-12);
      ASSERT_NEAR(melt.phi(i, j), melt.phi(100 - j, i), 1e-12); // a quarter turn
    }
}

TEST(Growth, QuarterIsTheWhole)
{
  const Mesh whole = test::square_mesh(81, 0.4, Boundary::no_flux);
  const Mesh quarter = test::square_mesh(41, 0.4, Boundary::symmetry);
  test::Melt one = test::seeded(whole, {16., 16.}, 4., 0.55);
  test::Melt part = test::seeded(quarter, {0., 0.}, 4., 0.55);
  Growth grow_one(whole, test::paper_law(0.05), GrowthOptions{}, 0.55);
  Growth grow_part(quarter, test::paper_law(0.05), GrowthOptions{}, 0.55);
  grow_one.advance(one.fields(), 0.8 * grow_one.step_limit(), 600);
  grow_part.advance(part.fields(), 0.8 * grow_one.step_limit(), 600);
  for (int j = 0; j <= 40; ++j)
    for (int i = 0; i <= 40; ++i)
      ASSERT_NEAR(part.phi(i, j), one.phi(40 + i, 40 + j), 1e-12);
}

// Gibbs-Thomson: a disc of radius R is in (unstable) equilibrium with a melt at -d0/R.
TEST(Growth, SmallDiscsMeltAndLargeOnesGrowAsGibbsThomsonSays)
{
  const double undercooling = 0.02, critical = 0.185 / undercooling; // 9.25 W0
  for (const double factor : {0.93, 1.07})
  {
    const Mesh mesh = test::square_mesh(81, 0.4, Boundary::symmetry);
    test::Melt melt = test::seeded(mesh, {0., 0.}, factor * critical, undercooling);
    Growth growth(mesh, test::paper_law(0.), GrowthOptions{}, undercooling);
    const double h = 0.9 * growth.step_limit();
    growth.advance(melt.fields(), h, 500); // the profile settles first
    const double area = solid_area(melt.phi, mesh);
    growth.advance(melt.fields(), h, 1500);
    const double change = solid_area(melt.phi, mesh) - area;
    EXPECT_GT(factor > 1. ? change : -change, 0.) << factor;
  }
}

TEST(Growth, OneCellSeedMeltsAway)
{
  const Mesh mesh = test::square_mesh(41, 0.4, Boundary::no_flux);
  test::Melt melt{Field<double>(mesh, -1.), Field<double>(mesh, -0.55)};
  melt.phi(20, 20) = 1.;
  Growth growth(mesh, test::paper_law(0.05), GrowthOptions{}, 0.55);
  growth.advance(melt.fields(), 0.8 * growth.step_limit(), 300);
  EXPECT_LT(solid_area(melt.phi, mesh), 0.01);
}

TEST(Growth, SurvivesWeakAndStrongUndercoolingAndAnisotropy)
{
  for (const double undercooling : {0.1, 0.9})
    for (const double anisotropy : {0., 0.0666})
    {
      const Mesh mesh = test::square_mesh(61, 0.4, Boundary::symmetry);
      test::Melt melt = test::seeded(mesh, {0., 0.}, 6., undercooling);
      Growth growth(mesh, test::paper_law(anisotropy), GrowthOptions{}, undercooling);
      EXPECT_NO_THROW(growth.advance(melt.fields(), 0.99 * growth.step_limit(), 2000));
    }
}

TEST(Growth, RefusesAStepPastItsLimit)
{
  const Mesh mesh = test::square_mesh(33, 0.4, Boundary::no_flux);
  test::Melt melt = test::seeded(mesh, {6.4, 6.4}, 4., 0.55);
  Growth growth(mesh, test::paper_law(0.05), GrowthOptions{}, 0.55);
  // nine points: 3 dx^2/(8 D); five points: dx^2/(4 D)
  EXPECT_NEAR(melt::heat_step_limit(mesh, growth.law(), scene::Laplacian::nine_point), 0.02, 1e-12);
  EXPECT_NEAR(melt::heat_step_limit(mesh, growth.law(), scene::Laplacian::five_point), 0.16 / 12.,
              1e-12);
  EXPECT_THROW(growth.advance(melt.fields(), 1.01 * growth.step_limit(), 1), std::invalid_argument);
}

TEST(Growth, CatchesTheBlowUpOfAForcedStepWithinAFewSteps)
{
  const Mesh mesh = test::square_mesh(33, 0.4, Boundary::no_flux);
  test::Melt melt = test::seeded(mesh, {6.4, 6.4}, 4., 0.55);
  GrowthOptions options;
  options.force = true;
  Growth growth(mesh, test::paper_law(0.05), options, 0.55);
  try
  {
    growth.advance(melt.fields(), 2.5 * growth.step_limit(), 48);
    FAIL() << "it went on";
  }
  catch (const medium::NumericalError &trouble)
  {
    const std::string message = trouble.what();
    EXPECT_NE(message.find("growth step"), std::string::npos) << message;
    EXPECT_NE(message.find(" has left its bounds"), std::string::npos) << message;
  }
}

// The fields have two copies that take turns; what is said is of the last one.
TEST(Growth, NamesTheSameNodeWhetherOddOrEvenStepsWereAsked)
{
  const Mesh mesh = test::square_mesh(33, 0.4, Boundary::no_flux);
  GrowthOptions options;
  options.force = true;
  std::string said[2];
  for (const int odd : {0, 1})
  {
    test::Melt melt = test::seeded(mesh, {6.4, 6.4}, 4., 0.55);
    Growth growth(mesh, test::paper_law(0.05), options, 0.55);
    try
    {
      growth.advance(melt.fields(), 2.5 * growth.step_limit(), 480 + odd);
    }
    catch (const medium::NumericalError &trouble)
    {
      said[odd] = trouble.what();
    }
  }
  EXPECT_NE(said[0].find("node ("), std::string::npos) << said[0];
  EXPECT_EQ(said[0], said[1]);
}

// A cosine of the temperature decays by 1 - h D K a step, K the eigenvalue of the Laplacian.
TEST(Heat, DiffusesACosineByTheDiscreteEigenvalue)
{
  Mesh mesh = test::square_mesh(33, 0.4, Boundary::no_flux);
  mesh.spacing[1] = 0.5;
  for (const auto laplacian : {scene::Laplacian::five_point, scene::Laplacian::nine_point})
  {
    Field<double> theta(mesh);
    const double kx = M_PI * 3. / 32., ky = M_PI * 5. / 32.;
    for (int j = 0; j < 33; ++j)
      for (int i = 0; i < 33; ++i)
        theta(i, j) = std::cos(kx * i) * std::cos(ky * j);
    const double x = 2. * (1. - std::cos(kx)) / 0.16, y = 2. * (1. - std::cos(ky)) / 0.25;
    const double cross =
        laplacian == scene::Laplacian::nine_point ? (0.16 + 0.25) / 12. * x * y : 0.;
    GrowthOptions options;
    options.laplacian = laplacian;
    Growth growth(mesh, {1., 1., 0., 0., 3.}, options, 0.);
    const double h = 0.5 * melt::heat_step_limit(mesh, growth.law(), laplacian);
    growth.advance({nullptr, &theta, nullptr, nullptr}, h, 7);
    EXPECT_NEAR(theta(0, 0), std::pow(1. - h * 3. * (x + y - cross), 7), 1e-13);
  }
}

TEST(Heat, KeepsFixedBorderValues)
{
  const Mesh mesh = test::square_mesh(17, 0.4, Boundary::fixed);
  Field<double> theta(mesh);
  for (int j = 0; j < 17; ++j)
    theta(0, j) = theta(j, 0) = 1.;
  Growth growth(mesh, {1., 1., 0., 0., 3.}, GrowthOptions{}, 0.);
  growth.advance({nullptr, &theta, nullptr, nullptr}, 0.5 * growth.step_limit(), 100);
  EXPECT_EQ(theta(0, 8), 1.);
  EXPECT_EQ(theta(16, 8), 0.);
  EXPECT_GT(theta(3, 8), 0.);
}
