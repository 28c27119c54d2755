// A held box with material around its corners: a disc that hangs on a patch of its inside.
#include <gtest/gtest.h>

#include "small_scenes.h"

TEST(Grip, WithMaterialAroundItsCornersHoldsAndCarriesTheWeight)
{
  for (const int per_cell : {2, 3})
  {
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, {1.2, 1.2}, {24, 24});
    scene.bodies[0].shape = scene::Disc{{0.6, 0.6}, 0.4};
    scene.mpm->points_per_cell = {per_cell, per_cell};
    scene::BodyForce weight;
    weight.acceleration = {small::text("0"), small::text("-10*smooth(t, 0.2)")};
    scene.body_force = weight;
    small::hold(scene, "foot", scene::Box{{0.5, 0.2}, {0.7, 0.32}}, "0", "0");
    const solid::Owner disc = solid::make_solid(scene);
    solid::advance(*disc, 0.6); // more than 400 steps: the shortest waves would have grown long ago
    const solid::History history = solid::history(*disc);
    const auto value = [&](const std::string &name) { return small::value_of(history, name); };
    // Half of the rise and what follows it, against what is still on its way.
    const double given = -10. * value("mass") * (0.5 * 0.2 + 0.4);
    EXPECT_NEAR(solid::reaction(*disc, "foot").impulse[1], value("momentum_y") - given,
                2e-3 * std::abs(given));
    EXPECT_GT(value("energy_balance"), -1e-3 * value("external_work"));
  }
}

// A footing in the middle of an edge: only nodes within half a cell of its ends move with it. At a
// corner of the body the nodes beyond it are held too.
TEST(Support, ThatEndsInsideAnEdgeHoldsHalfACellMore)
{
  scene::Scene scene = small::rectangle({0.2, 0.2}, {2., 1.}, {2.4, 1.4}, {24, 14});
  small::hold(scene, "footing", scene::Segment{{0.87, 1.2}, {1.43, 1.2}}, "0", "-0.01*t");
  const solid::Owner inside = solid::make_solid(scene);
  solid::NodalVelocity velocity;
  solid::advance(*inside, 1e-4, &velocity);
  const auto moves = [&](const int i)
  { return std::abs(velocity.y[12 * 25 + static_cast<std::size_t>(i)] + 0.01) < 1e-12; };
  for (int i = 2; i <= 22; ++i)
    EXPECT_EQ(moves(i), i >= 9 && i <= 14) << i; // 0.9 to 1.4: within 0.82 to 1.48
}

// A moving grip is material too: setting it in motion takes work, which the account of energy has.
TEST(Grip, TakesTheWorkOfItsOwnMotion)
{
  scene::Scene scene = small::rectangle({1., 0.5}, {1., 2.}, {3., 3.}, {15, 15});
  small::hold(scene, "head", scene::Box{{1., 1.5}, {2., 2.5}}, "0", "0.05*smooth(t, 0.2)");
  const solid::Owner specimen = solid::make_solid(scene);
  solid::advance(*specimen, 0.1); // fastest now
  const solid::History history = solid::history(*specimen);
  const auto value = [&](const std::string &name) { return small::value_of(history, name); };
  EXPECT_GT(value("kinetic_energy"), 0.04);
  EXPECT_LT(std::abs(value("energy_balance")), 0.02 * value("external_work"));
}

// A bar eight cells long between a held edge and a box that pulls but leaves the other direction
// free: the clamp is at the side of the box to two thirds of a cell, however the cells lie.
TEST(Driven, BoxClampsAtItsSide)
{
  for (const double shift : {0., 0.25, 0.5, 0.75})
  {
    const double x = 1. + 0.25 * shift;
    scene::Scene scene = small::rectangle({x, 1.}, {3., 1.}, {5., 3.}, {20, 12});
    small::hold(scene, "left", scene::Edge::left, "0", std::nullopt);
    small::hold(scene, "box", scene::Box{{x + 2., 0.}, {5., 3.}}, "2e-3*smooth(t, 3)",
                std::nullopt);
    const solid::Owner bar = solid::make_solid(scene);
    solid::advance(*bar, 3.2);
    solid::advance(*bar, 0.5);
    const double length = 1000. / 0.91 * 2e-3 / solid::reaction(*bar, "box").force[0];
    EXPECT_NEAR(length, 2., 0.67 * 0.25) << shift;
  }
}
