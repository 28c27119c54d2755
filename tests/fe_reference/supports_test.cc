// Directions that no support holds.
#include <gtest/gtest.h>

#include "small_scenes.h"

namespace
{
  // Two blocks side by side, their tops drawn up; nothing holds them in x.
  scene::Scene two_blocks()
  {
    scene::Scene scene = fe_test::solid_scene(1e6, {12, 8}, 2, 2);
    scene.bodies = {fe_test::rectangle(0., 0., 0.5, 1.), fe_test::rectangle(1., 0., 0.5, 1.)};
    scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "", "0"),
                      fe_test::support("top", scene::Edge::top, "", "0.1*t")};
    return scene;
  }
} // namespace

TEST(Supports, PinEveryPieceThatFloats)
{
  const scene::Scene scene = two_blocks();
  const fe::Problem problem = fe_test::problem_of(scene);
  EXPECT_EQ(problem.supports.pins.size(), 2u);
  EXPECT_EQ(problem.supports.pinned, "x");
  const fe::Outcome outcome = fe_test::solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  for (int n = 0; n < problem.mesh.nodes; ++n)
    for (const double middle : {0.25, 1.25})
    {
      const bool there = (problem.mesh.position[n] - fe::Point(middle, 0.5)).norm() < 1e-9;
      EXPECT_NEAR(there ? outcome.last.u[2 * n] : 0., 0., 1e-12) << middle;
    }
}

TEST(Supports, PinsCarryNoForce)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 4}, 2, 2);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  scene.supports = {fe_test::support("left", scene::Edge::left, "0", "")};
  scene::Traction load;
  load.name = "right";
  load.where = scene::Edge::right;
  load.traction = {fe_test::expression("0"), fe_test::expression("-100*t")};
  scene.tractions = {load};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = fe_test::solve(scene, problem);
  EXPECT_EQ(outcome.kind, fe::Outcome::Kind::diverged);
  EXPECT_NE(outcome.message.find("nothing holds the body in y"), std::string::npos)
      << outcome.message;
  EXPECT_EQ(outcome.stepping.retries, 1) << "no smaller increment helps";
}

// What is left over of two loads in balance is no net force.
TEST(Supports, PinsLetLoadsInBalancePass)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 4}, 2, 2);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  scene.supports = {fe_test::support("left", scene::Edge::left, "0", "")};
  for (const scene::Edge edge : {scene::Edge::top, scene::Edge::bottom})
  {
    scene::Traction load;
    load.where = edge;
    load.traction = {fe_test::expression("0"),
                     fe_test::expression(edge == scene::Edge::top ? "1e4*t*X" : "-1e4*t*X")};
    scene.tractions.push_back(load);
  }
  const fe::Problem problem = fe_test::problem_of(scene);
  EXPECT_EQ(fe_test::solve(scene, problem).kind, fe::Outcome::Kind::complete);
}

// Two loads that balance on the drawing: on edges that stretch unlike they balance to 5e-4 only.
TEST(Supports, PinsLetLoadsPassThatBalanceAsDrawn)
{
  scene::Scene scene = fe_test::solid_scene(1e7, {22, 20}, 1, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 0.5, 1.), fe_test::rectangle(0.5, 0., 0.5, 0.5)};
  scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "", "0")};
  for (const scene::Edge edge : {scene::Edge::left, scene::Edge::right})
  {
    scene::Traction load;
    load.where = edge;
    load.traction = {fe_test::expression(edge == scene::Edge::left ? "-0.5e5*t" : "1e5*t"),
                     fe_test::expression("0")};
    scene.tractions.push_back(load);
  }
  const fe::Problem problem = fe_test::problem_of(scene);
  EXPECT_EQ(fe_test::solve(scene, problem).kind, fe::Outcome::Kind::complete);
}
