// Whole bodies: Newton's order, analytic responses, rotation, loads, trouble.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/reader.h"
#include "small_scenes.h"

using fe_test::expression;
using fe_test::reaction;
using fe_test::solve;
using fe_test::support;

namespace
{
  // Strip 2 x 5 with free sides, ends free to contract: homogeneous plane strain tension.
  scene::Scene strip(const std::string &end_displacement, const int load_steps)
  {
    scene::Scene scene = fe_test::solid_scene(3e7, {1, 2}, 2, load_steps);
    scene.solid->yield_stress = 6e4;
    scene.bodies = {fe_test::rectangle(0., 0., 2., 5.)};
    scene.supports = {support("top", scene::Edge::top, "", end_displacement),
                      support("bottom", scene::Edge::bottom, "", "0"),
                      support("left", scene::Edge::left, "0", "")};
    return scene;
  }

  // A bar clamped at both ends and sheared far into yield.
  scene::Scene sheared_bar(const int degree, const int load_steps)
  {
    scene::Scene scene = fe_test::solid_scene(2e11, {4, 8}, degree, load_steps);
    scene.solid->yield_stress = 4e8;
    scene.bodies = {fe_test::rectangle(0., 0., 1., 2.)};
    scene.supports = {support("top", scene::Edge::top, "0.05*t", "0"),
                      support("bottom", scene::Edge::bottom, "-0.05*t", "0")};
    return scene;
  }
} // namespace

TEST(Newton, ConvergesQuadraticallyInPlasticFlow)
{
  const scene::Scene scene = sheared_bar(2, 20);
  const fe::Problem problem = fe_test::problem_of(scene);
  int quadratic = 0, plastic_steps = 0;
  const auto observe = [&](const fe::Step &step)
  {
    const std::vector<double> &r = step.newton.residuals;
    if (step.stepping.steps < 10 || r.size() < 2)
      return;
    ++plastic_steps;
    // r_{k+1} = C r_k^2: the last decade pair more than halves the exponent.
    if (std::log(r[r.size() - 1]) < 1.5 * std::log(r[r.size() - 2]) || r.back() < 1e-11)
      ++quadratic;
  };
  ASSERT_EQ(solve(scene, problem, observe).kind, fe::Outcome::Kind::complete);
  ASSERT_GE(plastic_steps, 5);
  EXPECT_GE(quadratic, plastic_steps - 1);
}

// Oblique cells round what squares would leave 0; the load comes after half the time.
TEST(Newton, TakesABodyWithoutLoadForOneInEquilibrium)
{
  for (const double poisson_ratio : {0., 0.3, 0.49})
  {
    scene::Scene scene = fe_test::solid_scene(1e4, {6, 6}, 2, 4);
    scene.solid->poisson_ratio = poisson_ratio;
    scene::Body body;
    body.shape = scene::Polygon{{{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}},
                                 {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}}};
    scene.bodies = {body};
    scene.supports = {support("bottom", scene::Edge::bottom, "0", "0"),
                      support("top", scene::Edge::top, "0", "0.01*max(0, t - 0.5)")};
    const fe::Problem problem = fe_test::problem_of(scene);
    const fe::Outcome outcome = solve(scene, problem);
    ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete) << poisson_ratio << outcome.message;
    EXPECT_EQ(outcome.stepping.steps, 4);
  }
}

TEST(Strip, FollowsElasticAndPerfectlyPlasticPlaneStrain)
{
  // sigma_y = E eps/(1 - nu^2) until yield; near the plateau 2/sqrt(3) sigma_Y = 69282 at 0.5 %,
  // where the 0-D integration gives 69211. (Much further a perfectly plastic strip necks.)
  const scene::Scene scene = strip("5*(exp(0.005*t) - 1)", 200);
  const fe::Problem problem = fe_test::problem_of(scene);
  double at_one_thousandth = 0.;
  const auto observe = [&](const fe::Step &step)
  {
    if (std::abs(step.state.time - 0.2) < 1e-12)
      at_one_thousandth = step.state.points.front().stress[fe::yy];
  };
  const fe::Outcome outcome = solve(scene, problem, observe);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  EXPECT_NEAR(at_one_thousandth, 3e7 * 1e-3 / (1. - 0.09), 0.0005 * 32967.);
  const fe::PointState &point = outcome.last.points.front();
  EXPECT_NEAR(point.stress[fe::yy], 69211., 0.0005 * 69211.);
  EXPECT_NEAR(point.stress[fe::xx], 0., 1.);
  EXPECT_NEAR(fe::von_mises(point.stress), 6e4, 1e-6);
}

TEST(Strip, PerzynaPlateauIsAboveYieldByViscosityTimesRate)
{
  // Plane strain plateau: (2/sqrt 3)(sigma_Y + (2/sqrt 3) eta rate), here at 1e-2 /s for 2 s.
  scene::Scene scene = strip("5*(exp(0.01*t) - 1)", 400);
  scene.solid->viscosity = 3e6;
  scene.clock.end = 2.;
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  const double root = 2. / std::sqrt(3.);
  EXPECT_NEAR(outcome.last.points.front().stress[fe::yy], root * (6e4 + root * 3e6 * 1e-2),
              0.001 * 1.09e5);
}

TEST(Strip, LoadReversalIsFollowedWithoutSmallerSteps)
{
  const scene::Scene scene = strip("0.025*(t < 0.5 ? 2*t : 2 - 2*t)", 40);
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  EXPECT_EQ(outcome.stepping.steps, 40);
  EXPECT_LT(outcome.last.points.front().stress[fe::yy], -6e4); // compressed after plastic tension
}

TEST(Block, TurnsItsStressRigidlyWhenOnlyItsRimIsDriven)
{
  // A quarter turn in 20 steps, inside free: sigma_xx and sigma_yy change places, no flow.
  scene::Scene scene = fe_test::solid_scene(2e9, {3, 3}, 2, 20);
  scene.solid->yield_stress = 8e6;
  scene.bodies = {fe_test::rectangle(-1., -1., 2., 2.)};
  scene.bodies[0].initial_stress = {expression("3e6"), expression("-1e6"), expression("5e5"),
                                    expression("1e6")};
  for (const scene::Edge edge :
       {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
    scene.supports.push_back(support("rim", edge, "X*(cos(pi/2*t) - 1) - Y*sin(pi/2*t)",
                                     "X*sin(pi/2*t) + Y*(cos(pi/2*t) - 1)"));
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  for (const fe::PointState &point : outcome.last.points)
  {
    EXPECT_NEAR(point.stress[fe::xx], -1e6, 1.);
    EXPECT_NEAR(point.stress[fe::yy], 3e6, 1.);
    EXPECT_NEAR(point.stress[fe::zz], 5e5, 1.);
    EXPECT_NEAR(point.stress[fe::xy], -1e6, 1.);
    EXPECT_EQ(point.plastic_strain, 0.);
  }
}

TEST(Cantilever, MeetsTimoshenkoWithItsExactFieldImposed)
{
  // Plane strain Timoshenko field, load P/1000 so that finite strain does not show. The tip of the
  // centre line: cubic in x, so quadratic elements are exact to their interpolation error.
  const double E = 3e7 / (1. - 0.09), nu = 0.3 / 0.7, P = 0.1, I = 1. / 12.;
  scene::Scene scene = fe_test::solid_scene(3e7, {32, 4}, 2, 1);
  scene.bodies = {fe_test::rectangle(0., -0.5, 8., 1.)};
  const std::string factor = std::to_string(P / (6. * E * I) * 1e12) + "e-12*t";
  scene.supports = {support("root", scene::Edge::left,
                            "-" + factor + "*Y*(" + std::to_string(2. + nu) + ")*(Y^2 - 0.25)",
                            factor + "*3*" + std::to_string(nu) + "*Y^2*8")};
  scene::Traction load;
  load.where = scene::Edge::right;
  load.traction = {expression("0"), expression("t*0.6*(0.25 - Y^2)")};
  scene.tractions = {load};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  const double tip = P / (6. * E * I) * ((4. + 5. * nu) * 8. / 4. + 2. * 512.);
  for (int n = 0; n < problem.mesh.nodes; ++n)
    if ((problem.mesh.position[n] - fe::Point(8., 0.)).norm() < 1e-9)
    {
      EXPECT_NEAR(outcome.last.u[2 * n + 1] / tip, 1., 1e-4);
    }
  EXPECT_NEAR(reaction(problem, outcome.last, 0, 1), -P, 1e-6 * P);
}

TEST(Loads, BodyForceIsCarriedByTheSupport)
{
  scene::Scene scene = fe_test::solid_scene(1e9, {2, 3}, 2, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 2.)};
  scene.supports = {support("floor", scene::Edge::bottom, "0", "0")};
  scene.body_force.emplace();
  scene.body_force->acceleration = {expression("0"), expression("-9.81*t")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  // The mass is that of the initial volume, 2 m^2 x 1000 kg/m^3, whatever the settlement.
  EXPECT_NEAR(reaction(problem, outcome.last, 0, 1), 2000. * 9.81, 1e-4);
}

TEST(Loads, FollowerTractionGrowsWithTheDeformedSide)
{
  // Stretched by 50 % in x; the traction on top is a force per deformed length.
  scene::Scene scene = fe_test::solid_scene(1e6, {2, 2}, 2, 10);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.supports = {support("left", scene::Edge::left, "0", ""),
                    support("right", scene::Edge::right, "0.5*t", ""),
                    support("floor", scene::Edge::bottom, "", "0")};
  scene::Traction load;
  load.where = scene::Edge::top;
  load.traction = {expression("0"), expression("100*t")};
  scene.tractions = {load};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  EXPECT_NEAR(reaction(problem, outcome.last, 2, 1), -150., 1e-3);
}

// Loads that begin and end inside sides of the mesh, on a structured mesh and on one by Gmsh: all
// of the force is carried, not only that on whole sides.
TEST(Loads, BeginAndEndInsideSides)
{
  for (const bool outline : {false, true})
  {
    scene::Scene scene = fe_test::solid_scene(1e9, {10, 5}, 2, 1);
    scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
    if (outline)
      scene.bodies[0].shape = scene::Polygon{{{{0., 0.}, {2., 0.}, {2., 1.}, {0., 1.}}}};
    scene.supports = {support("floor", scene::Edge::bottom, "0", "0")};
    scene::Traction segment, box;
    segment.where = scene::Segment{{0.43, 1.}, {0.53, 1.}}; // inside one side or across two
    segment.traction = {expression("300"), expression("-1000")};
    box.where = scene::Box{{1.33, 0.9}, {1.78, 1.1}};
    box.pressure = expression("2000*X");
    scene.tractions = {segment, box};
    const fe::Problem problem = fe_test::problem_of(scene);
    const fe::Outcome outcome = solve(scene, problem);
    ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
    EXPECT_NEAR(reaction(problem, outcome.last, 0, 0), -30., 1e-2);
    EXPECT_NEAR(reaction(problem, outcome.last, 0, 1), 100. + 1000. * (1.78 * 1.78 - 1.33 * 1.33),
                1e-2);
  }
}

TEST(Energies, ExternalWorkIsStoredOrDissipated)
{
  const scene::Scene scene = sheared_bar(2, 200);
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  const fe::Energies &energies = outcome.stepping.energies;
  EXPECT_GT(energies.plastic, 10. * energies.elastic);
  EXPECT_NEAR((energies.elastic + energies.plastic) / energies.external, 1., 2e-3);
}

TEST(NumericalError, ImpossibleLoadSaysTimePlaceAndRemedy)
{
  // The ends of the bar are driven through each other: no equilibrium can be found to the end.
  scene::Scene scene = fe_test::solid_scene(1e6, {1, 2}, 2, 20);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.supports = {support("top", scene::Edge::top, "0", "-2*t"),
                    support("bottom", scene::Edge::bottom, "0", "0")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::diverged);
  EXPECT_NE(outcome.message.find("no equilibrium beyond t = "), std::string::npos);
  EXPECT_NE(outcome.message.find("near X = ("), std::string::npos);
  EXPECT_NE(outcome.message.find("Remedy"), std::string::npos);
  EXPECT_GT(outcome.last.smallest_jacobian, 0.); // the last good state is kept
  EXPECT_GT(outcome.last.time, 0.2);
}

TEST(Supports, RefuseToHoldNothing)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {1, 1}, 1, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.supports = {support("bottom", scene::Edge::bottom, "0", "0"),
                    support("nowhere", scene::Box{{1.4, 0.4}, {1.6, 0.6}}, "0", "0")};
  EXPECT_THROW(fe_test::problem_of(scene), scene::BadScene);
}
