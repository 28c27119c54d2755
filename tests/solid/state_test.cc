#include <gtest/gtest.h>

#include "scene/reader.h"
#include "small_scenes.h"
#include "solid/fields.h"
#include "solid/points.h"

using scene::Edge;

namespace
{
  std::string message(const scene::Scene &scene)
  {
    try
    {
      solid::make_solid(scene);
    }
    catch (const scene::BadScene &error)
    {
      return error.what();
    }
    return "";
  }
} // namespace

TEST(Points, NeedAtMost130Bytes)
{
  EXPECT_LE(solid::bytes_per_point(), 130u);
}

TEST(Threads, DoNotChangeABit)
{
  const scene::Scene scene = small::sheared_bar(20, 0.03);
  const solid::Owner one = solid::make_solid(scene, 1);
  solid::advance(*one, 0.03);
  for (const int threads : {2, 3, 16}) // 16: more than there are blocks of rows
  {
    const solid::Owner many = solid::make_solid(scene, threads);
    solid::advance(*many, 0.03);
    EXPECT_TRUE(solid::checkpoint(*one) == solid::checkpoint(*many)) << threads << " threads";
  }
}

TEST(Checkpoint, GoesOnToTheSameBits)
{
  const scene::Scene scene = small::sheared_bar(10, 0.06);
  const solid::Owner whole = solid::make_solid(scene), later = solid::make_solid(scene);
  solid::advance(*whole, 0.03);
  solid::restore(*later, solid::checkpoint(*whole));
  solid::advance(*whole, 0.03), solid::advance(*later, 0.03);
  EXPECT_TRUE(solid::checkpoint(*whole) == solid::checkpoint(*later));
  EXPECT_EQ(solid::reaction(*whole, "top").force[0], solid::reaction(*later, "top").force[0]);
}

TEST(Checkpoint, OfAnotherSceneIsRefused)
{
  const solid::Owner bar = solid::make_solid(small::sheared_bar(10, 0.06));
  scene::Scene other = small::sheared_bar(10, 0.06);
  other.mpm->mach = 1e-3;
  const solid::Owner denser = solid::make_solid(other);
  EXPECT_THROW(solid::restore(*denser, solid::checkpoint(*bar)), std::runtime_error);
}

TEST(MachNumber, ScalesTheDensityToTheWantedWaveSpeed)
{
  const solid::Owner bar = solid::make_solid(small::sheared_bar(10, 1.));
  EXPECT_NEAR(solid::density_scaling(*bar).wave_speed, 0.4 / 2e-3, 1e-3 * 200.);
}

TEST(BadInput, MachWithoutMotionSaysWhatToGive)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.mpm->mach = 1e-3;
  EXPECT_NE(message(scene).find("reference_speed"), std::string::npos);
}

TEST(BadInput, CellsThatAreNotSquareAreRefused)
{
  const scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 16});
  EXPECT_NE(message(scene).find("square"), std::string::npos);
}

TEST(BadInput, ASupportThatTouchesNothingIsRefused)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.bodies[0].shape = scene::Disc{{1.5, 1.5}, 0.4};
  small::hold(scene, "top", Edge::top, "0", "0");
  EXPECT_NE(message(scene).find("less of the outline than the half cell"), std::string::npos);
}

TEST(BadInput, ABodyOutOfTheDomainIsRefused)
{
  const scene::Scene scene = small::rectangle({2.5, 1.}, {1., 1.}, {3., 3.}, {15, 15});
  EXPECT_NE(message(scene).find("out of the domain"), std::string::npos);
}

TEST(NumericalError, APointLeavingTheMeshIsFoundWithItsPlace)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.bodies[0].velocity[0] = small::text("5");
  const solid::Owner block = solid::make_solid(scene);
  try
  {
    solid::advance(*block, 1.);
    FAIL() << "it crossed the side of the domain unseen";
  }
  catch (const solid::NumericalError &trouble)
  {
    EXPECT_NEAR(trouble.place[0], 3., 0.2);
    EXPECT_NE(std::string(trouble.what()).find("left the mesh"), std::string::npos);
  }
}

TEST(NumericalError, TooLargeAStepIsFoundWithinFewSteps)
{
  scene::Scene scene = small::sheared_bar(10, 1.);
  scene.mpm->step_fraction = 3.;
  const solid::Owner bar = solid::make_solid(scene);
  EXPECT_THROW(solid::advance(*bar, 1.), solid::NumericalError);
  EXPECT_LT(solid::steps(*bar), 200);
}

TEST(Supports, AGripMovesItsMaterialRigidly)
{
  scene::Scene scene = small::rectangle({1., 0.5}, {1., 2.}, {3., 3.}, {15, 15});
  small::hold(scene, "foot", scene::Box{{1., 0.5}, {2., 1.}}, "0", "0");
  small::hold(scene, "head", scene::Box{{1., 2.}, {2., 2.5}}, "0", "0.01*smooth(t, 2)");
  const solid::Owner specimen = solid::make_solid(scene);
  solid::advance(*specimen, 2.5);
  solid::advance(*specimen, 0.5);
  const auto head = solid::region_means(*specimen, {scene::Box{{1., 2.}, {2., 2.5}}},
                                        {"displacement_y", "von_mises"});
  EXPECT_NEAR(head[0], 0.01, 1e-9);
  EXPECT_EQ(head[1], 0.);
  // Clamped plane strain lies between the free-sided and the confined modulus.
  const double force = solid::reaction(*specimen, "head").force[1];
  EXPECT_GT(force, 1000. / 0.91 * 0.01);
  EXPECT_LT(force, 1346. * 0.01);
  EXPECT_NEAR(solid::reaction(*specimen, "foot").force[1], -force, 0.01 * force);
}

// sxx grows with the height above the middle of a slender beam, by 1 per length.
TEST(Observation, APointAveragesOverASquareOfItsSurroundings)
{
  scene::Scene scene = small::rectangle({0.5, 0.5}, {4., 0.4}, {5., 1.4}, {50, 14});
  const solid::Owner beam = solid::make_solid(scene);
  solid::Points &points = beam->points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.sxx[p] = points.y[p] - 0.7;
  const auto at_the_top = [&](const std::optional<double> bin) {
    return solid::sample_point(*beam, {{2.5, 0.9}, scene::Frame::material, bin}, {"stress_xx"})[0];
  };
  // Half of the square lies in the beam. Points stand for squares of a third of a cell, 0.033.
  EXPECT_NEAR(at_the_top(0.2), 0.2 - 0.05, 0.2 * 0.033);
  EXPECT_NEAR(at_the_top({}), 0.2 - 0.025, 0.2 * 0.033) << "a cell: 0.4/20 is less";
  scene::LineProbe line{{2.4, 0.9}, {2.6, 0.9}, 3, scene::Frame::current, {}};
  EXPECT_EQ(solid::sample_line(*beam, line, {"stress_xx"}).values[1], at_the_top({}));
}

TEST(Observation, IsTheSameOfSomePointsAsOfAll)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.bodies[0].velocity[0] = small::text("0.3*sin(3*X)*Y");
  const solid::Owner block = solid::make_solid(scene);
  solid::advance(*block, 0.3);
  const solid::PointSelection all = solid::all_points(*block), some{7, 50, 51, 99};
  for (const char *name : {"log_strain_xx", "displacement_x", "von_mises", "jacobian"})
  {
    const auto of_all = solid::field(*block, name, all), of_some = solid::field(*block, name, some);
    ASSERT_EQ(of_some.size(), some.size());
    for (std::size_t k = 0; k < some.size(); ++k)
      EXPECT_NEAR(of_some[k], of_all[some[k]], 1e-13 * (1. + std::abs(of_all[some[k]]))) << name;
  }
}

// 3.6e9 cells, more than an int counts and most machines hold: only those near the points matter.
TEST(Observation, FindsItsPointsInACornerOfALargeDomain)
{
  scene::Scene scene =
      small::rectangle({11996., 11996.}, {1., 1.}, {12000., 12000.}, {60000, 60000});
  scene.bodies[0].velocity[0] = small::text("1 + 2*(X - 11996) - 3*(Y - 11996)");
  const solid::Owner block = solid::make_solid(scene);
  const scene::PointProbe middle{{11996.5, 11996.4}, scene::Frame::material};
  EXPECT_NEAR(solid::sample_point(*block, middle, {"velocity_x"})[0], 0.8, 1e-8);
  EXPECT_EQ(solid::sample_point(*block, middle, {"von_mises"})[0], 0.);
}

TEST(Observation, LineIsExactForLinearFieldsAndMissingOutside)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.bodies[0].velocity[0] = small::text("1 + 2*X - 3*Y");
  const solid::Owner block = solid::make_solid(scene);
  scene::LineProbe line;
  line.a = {0.5, 1.5}, line.b = {2., 1.5}, line.points = 4;
  const record::LineSample sample = solid::sample_line(*block, line, {"velocity_x", "von_mises"});
  EXPECT_TRUE(std::isnan(sample.values[0]));
  EXPECT_TRUE(std::isnan(sample.values[1]));
  for (std::size_t k = 1; k < 4; ++k)
    EXPECT_NEAR(sample.values[2 * k], 1. + 2. * sample.position[k][0] - 4.5, 1e-12);
}
