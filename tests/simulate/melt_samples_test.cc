#include "melt_samples.h"
#include "simulate.h"

#include <cmath>

#include <gtest/gtest.h>

// Two rows of three columns; the solid knows the outer two, in another order.
TEST(MeltSamples, SolidColumnsAreLaidOverTheirNames)
{
  std::vector<double> values{0., 1., 0., 0., 2., 0.};
  overlay(values, {"stress_xx", "phi", "stress_yy"}, {10., 20., 30., 40.},
          {"stress_yy", "stress_xx"});
  EXPECT_EQ(values, (std::vector<double>{20., 1., 10., 40., 2., 30.}));
}

TEST(MeltSamples, ImposedVelocityIsWhatTheSceneSays)
{
  scene::Scene scene;
  scene.domain.size = {2., 2.}, scene.domain.cells = {20, 20};
  scene.heat.emplace();
  scene.heat->diffusivity = 1.;
  scene.imposed.emplace();
  const scene::SourceLocation place{"test", 1, "test"};
  scene.imposed->velocity = {scene::Expression{"3*y", place}, scene::Expression{"-x", place}};
  const World world = build_world(scene, 1);
  const auto sample = sample_melt(world, {{0.53, 1.27}}, {"velocity_y", "theta", "velocity_x"});
  EXPECT_NEAR(sample.values[0], -0.53, 1e-12);
  EXPECT_NEAR(sample.values[1], -scene.heat->undercooling, 1e-12);
  EXPECT_NEAR(sample.values[2], 3.81, 1e-12);
}

TEST(MeltSamples, NothingIsBehindAWall)
{
  scene::Scene scene;
  scene.domain.size = {8., 8.}, scene.domain.cells = {16, 16};
  scene.heat.emplace();
  scene.heat->diffusivity = 1.;
  scene::Wall wall;
  wall.side = scene::Edge::top, wall.speed = 1., wall.travel = 2., wall.start_time = 0.;
  scene.walls = {wall};
  scene.clock.end = 2.;
  World world = build_world(scene, 1);
  while (world.time < 1.2)
    step(world, std::min(coupling_step(world), 1.2 - world.time));
  const auto sample = sample_melt(world, {{4., 6.7}, {4., 6.9}, {4., 7.9}}, {"theta"});
  EXPECT_TRUE(std::isfinite(sample.values[0]));
  EXPECT_TRUE(std::isnan(sample.values[1])) << "the wall stands at 6.8";
  EXPECT_TRUE(std::isnan(sample.values[2]));
}
