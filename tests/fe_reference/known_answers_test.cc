// Problems with closed-form answers that no solver of this project made.
#include <gtest/gtest.h>

#include <cmath>

#include "small_scenes.h"

using fe_test::expression;
using fe_test::reaction;
using fe_test::solve;
using fe_test::support;

namespace
{
  scene::Traction pressure_in(const scene::Box &box, const std::string &pressure)
  {
    scene::Traction load;
    load.where = box;
    load.pressure = expression(pressure);
    return load;
  }

  // A quarter of a ring between symmetry sides, radii 1 and 2, under internal pressure.
  scene::Scene ring(const int cells, const std::string &pressure, const int load_steps)
  {
    scene::Scene scene = fe_test::solid_scene(1000., {cells, cells}, 2, load_steps);
    scene.domain.size = {2.4, 2.4};
    scene.domain.cells = {24, 24};
    scene.domain.boundary = {scene::Boundary::symmetry, scene::Boundary::no_flux,
                             scene::Boundary::symmetry, scene::Boundary::no_flux};
    scene::Body body;
    body.shape = scene::Ring{{0., 0.}, 1., 2.};
    scene.bodies = {body};
    scene.tractions = {pressure_in({{-1.1, -1.1}, {1.1, 1.1}}, pressure)};
    return scene;
  }

  // Largest relative error of the radial displacement against Lame's solution for p = 0.01:
  // u = (1 + nu) p a^2/(E (b^2 - a^2)) ((1 - 2 nu) r + b^2/r).
  double error_against_lame(const int cells)
  {
    const scene::Scene scene = ring(cells, "0.01*t", 1);
    const fe::Problem problem = fe_test::problem_of(scene);
    const fe::Outcome outcome = solve(scene, problem);
    EXPECT_EQ(outcome.kind, fe::Outcome::Kind::complete);
    double largest = 0.;
    for (int n = 0; n < problem.mesh.nodes; ++n)
    {
      const fe::Point X = problem.mesh.position[n];
      const double r = X.norm();
      const double lame = 1.3 * 0.01 / (1000. * 3.) * (0.4 * r + 4. / r);
      const double u = (outcome.last.u[2 * n] * X[0] + outcome.last.u[2 * n + 1] * X[1]) / r;
      largest = std::max(largest, std::abs(u / lame - 1.));
    }
    return largest;
  }
} // namespace

TEST(Ring, ConvergesToLameUnderInternalPressure)
{
  // Sides are straight, so the edges are polygons: second order.
  const double coarse = error_against_lame(10), fine = error_against_lame(20);
  EXPECT_LT(fine, 4e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(Ring, CarriesItsPlasticLimitPressureAndNoMore)
{
  // 2/sqrt(3) sigma_Y ln(b/a), R. Hill, The Mathematical Theory of Plasticity (1950), ch. 5; the
  // ring is strained by less than 1 % before, which moves the limit by as little.
  scene::Scene scene = ring(8, "0.9*t", 30);
  scene.solid->yield_stress = 1.;
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::diverged);
  EXPECT_NEAR(0.9 * outcome.last.time, 2. / std::sqrt(3.) * std::log(2.), 0.008);
}

TEST(Pressure, PressesAtARightAngleOnASideThatTurns)
{
  // A block turned by a quarter: its top has become its left side, pushed towards +x.
  scene::Scene scene = fe_test::solid_scene(2e9, {2, 2}, 2, 10);
  scene.bodies = {fe_test::rectangle(-1., -1., 2., 2.)};
  scene.supports = {support("all", scene::Box{{-1., -1.}, {1., 1.}},
                            "X*(cos(pi/2*t) - 1) - Y*sin(pi/2*t)",
                            "X*sin(pi/2*t) + Y*(cos(pi/2*t) - 1)")};
  scene.tractions = {pressure_in({{-1., 0.9}, {1., 1.1}}, "300*t")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  EXPECT_NEAR(reaction(problem, outcome.last, 0, 0), -300. * 2., 1e-3);
  EXPECT_NEAR(reaction(problem, outcome.last, 0, 1), 0., 1e-3);
}

TEST(Pressure, HasAnExactTangent)
{
  // A soft block blown up from below by a third of its modulus: Newton stays quadratic.
  scene::Scene scene = fe_test::solid_scene(1e6, {3, 3}, 2, 10);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.supports = {support("left", scene::Edge::left, "0", "0"),
                    support("right", scene::Edge::right, "0", "0")};
  scene.tractions = {pressure_in({{0., -0.1}, {1., 0.1}}, "3e5*t")};
  const fe::Problem problem = fe_test::problem_of(scene);
  int quadratic = 0, steps = 0;
  const auto observe = [&](const fe::Step &step)
  {
    const std::vector<double> &r = step.newton.residuals;
    if (r.size() < 2)
      return;
    ++steps;
    quadratic += std::log(r.back()) < 1.5 * std::log(r[r.size() - 2]) || r.back() < 1e-11;
  };
  ASSERT_EQ(solve(scene, problem, observe).kind, fe::Outcome::Kind::complete);
  ASSERT_GE(steps, 5);
  EXPECT_GE(quadratic, steps - 1);
}

TEST(SimpleShear, StressIsTheSineOfTheShear)
{
  // Jaumann's rate under simple shear: sigma_xy = G sin(gamma), sigma_xx = G (1 - cos(gamma)) =
  // -sigma_yy (J. K. Dienes, Acta Mech. 32 (1979) 217), here to gamma = 2.
  scene::Scene scene = fe_test::solid_scene(2.6e6, {2, 2}, 2, 200);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  for (const scene::Edge edge :
       {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
    scene.supports.push_back(support("rim", edge, "2*t*Y", "0"));
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  for (const fe::PointState &point : outcome.last.points)
  {
    EXPECT_NEAR(point.stress[fe::xy], 1e6 * std::sin(2.), 1e2);
    EXPECT_NEAR(point.stress[fe::xx], 1e6 * (1. - std::cos(2.)), 1e2);
    EXPECT_NEAR(point.stress[fe::yy], -1e6 * (1. - std::cos(2.)), 1e2);
  }
}

TEST(LoadSteps, ShrinkWhereNewtonFailsAndGoOnToTheEnd)
{
  // Two steps to a shear of 40 % in the clamped bar are too large for any element.
  scene::Scene scene = fe_test::solid_scene(2e11, {4, 8}, 2, 2);
  scene.solid->yield_stress = 4e8;
  scene.bodies = {fe_test::rectangle(0., 0., 1., 2.)};
  scene.supports = {support("top", scene::Edge::top, "0.4*t", "0"),
                    support("bottom", scene::Edge::bottom, "-0.4*t", "0")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  EXPECT_DOUBLE_EQ(outcome.last.time, 1.);
  EXPECT_GT(outcome.stepping.retries, 0);
  EXPECT_GT(outcome.stepping.steps, 2);
}

// A clamped strut, straight and pressed along itself, stays straight beyond Euler's shortening
// 4 pi^2 I/(A L^2) = (pi h/L)^2/3, where that is no stable equilibrium any more: it says so.
TEST(Strut, TellsWhereItWouldBuckle)
{
  const double euler = std::pow(std::acos(-1.) / 20., 2) / 3., most = 1.5 * euler;
  scene::Scene scene = fe_test::solid_scene(1e4, {40, 2}, 2, 60);
  scene.bodies = {fe_test::rectangle(0., 0., 20., 1.)};
  scene.supports = {
      fe_test::support("left", scene::Edge::left, "0", "0"),
      fe_test::support("right", scene::Edge::right, std::to_string(-20. * most) + "*t", "0")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = fe_test::solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete) << outcome.message;
  if (fe::LinearSystem(problem.mesh).solver_name() != std::string("Amesos_Mumps"))
    GTEST_SKIP() << "this Trilinos has no MUMPS, and KLU tells no determinant";
  ASSERT_TRUE(outcome.unstable_since.has_value());
  EXPECT_NEAR(*outcome.unstable_since * most, euler, 0.05 * euler);

  scene.supports.back() =
      fe_test::support("right", scene::Edge::right, std::to_string(20. * most) + "*t", "0");
  EXPECT_FALSE(fe_test::solve(scene, fe_test::problem_of(scene)).unstable_since) << "pulled";
}
