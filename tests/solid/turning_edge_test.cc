// Edges held along themselves and free across, which turn with their material.
#include <gtest/gtest.h>

#include "small_scenes.h"

// A cantilever whose tip is pushed down by its end face, free to slide inwards: the face turns by
// 17 degrees. fe_reference: -386.5 at half of the whole push, -598.8 here.
TEST(TurningEdge, PushesAsFarAsItIsTold)
{
  scene::Scene scene = small::rectangle({0.25, 2.5}, {4., 1.}, {5., 6.}, {40, 48});
  scene.solid->young_modulus = 1e5;
  scene.mpm->mach = 0.005;
  small::hold(scene, "root", scene::Edge::left, "0", "0");
  small::hold(scene, "tip", scene::Edge::right, std::nullopt, "-1.6*smooth(t, 1)");
  const solid::Owner beam = solid::make_solid(scene);
  solid::advance(*beam, 0.495);
  solid::advance(*beam, 0.01);
  EXPECT_NEAR(solid::reaction(*beam, "tip").force[1] / -386.5, 1., 0.015);
  solid::advance(*beam, 0.09);
  solid::advance(*beam, 0.01);
  EXPECT_NEAR(solid::reaction(*beam, "tip").force[1] / -598.8, 1., 0.025);
  EXPECT_DOUBLE_EQ(solid::reaction(*beam, "tip").force[0], 0.);
  const solid::History history = solid::history(*beam);
  EXPECT_LT(std::abs(small::value_of(history, "energy_balance")),
            0.01 * small::value_of(history, "external_work"));
}

// A block pressed on the left half of a top that cannot move sideways and bends by two cells.
// fe_reference: 22.11 on the top, -31.47 on the bottom.
TEST(TurningEdge, BearsTheShearOfAnEdgeThatBends)
{
  scene::Scene scene = small::rectangle({0.5, 0.5}, {2., 1.}, {3., 2.}, {48, 32});
  scene.mpm->mach = 0.005, scene.mpm->reference_speed = 0.4;
  small::hold(scene, "bottom", scene::Edge::bottom, "0", "0");
  small::hold(scene, "top", scene::Edge::top, "0", std::nullopt);
  scene::Traction load;
  load.name = "press", load.where = scene::Segment{{0.5, 1.5}, {1.5, 1.5}};
  load.traction = {small::text("0"), small::text("0")};
  load.pressure = small::text("200*smooth(t, 1)");
  scene.tractions.push_back(load);
  const solid::Owner block = solid::make_solid(scene);
  solid::advance(*block, 1.);
  solid::advance(*block, 0.1);
  EXPECT_NEAR(solid::reaction(*block, "top").force[0] / 22.11, 1., 0.02);
  EXPECT_NEAR(solid::reaction(*block, "bottom").force[0] / -31.47, 1., 0.02);
}

// Which nodes are tied is found from the tracers, which a checkpoint has: the same bits.
TEST(TurningEdge, GoesOnToTheSameBitsAfterARestart)
{
  scene::Scene scene = small::rectangle({0.25, 0.5}, {2., 0.5}, {2.5, 1.5}, {20, 12});
  small::hold(scene, "root", scene::Edge::left, "0", "0");
  small::hold(scene, "tip", scene::Edge::right, std::nullopt, "-0.3*smooth(t, 1)");
  const solid::Owner whole = solid::make_solid(scene), second = solid::make_solid(scene);
  solid::advance(*whole, 0.5);
  solid::restore(*second, solid::checkpoint(*whole));
  solid::advance(*whole, 0.3);
  solid::advance(*second, 0.3);
  EXPECT_EQ(solid::checkpoint(*whole), solid::checkpoint(*second));
}
