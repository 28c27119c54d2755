// How large a crystal is estimated to become, against solvability theory and what runs have shown.
#include <gtest/gtest.h>

#include "forecast_growth.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  /// A seed in the middle of a square of that side, in W0, grown until its arms reach the sides.
  scene::Scene crystal(const double side, const std::string &more = "")
  {
    const std::string middle = std::to_string(0.5 * side), whole = std::to_string(side);
    return scene_of("title = \"t\"\n[domain]\nsize = [" + whole + ", " + whole +
                    "]\ncells = [64, 64]\n[[body]]\nshape = \"disc\"\ncentre = [" + middle + ", " +
                    middle +
                    "]\nradius = 8.0\n[clock]\nend = 1e4\n[phase_field]\nwidth = 1.0\n[growth]\n"
                    "anisotropy = 0.06\ncapillary_length = 0.185\n[heat]\ndiffusivity = 3.0\n"
                    "undercooling = 0.55\n" +
                    more);
  }

  double solid_area(const scene::Scene &scene)
  {
    return growth_load(build_world(scene, 1)).solid_area;
  }
} // namespace

TEST(Crystal, HasTheParabolaOfTheory)
{
  // Ivantsov's Pe = 0.257 at undercooling 0.55 and Table 1's V d0/D = 0.01703 at eps = 0.05:
  // rho/d0 = 2 x 0.257/0.01703 = 30.2, the velocity within the tenth that the fit is good for.
  scene::Scene scene = crystal(100.);
  scene.growth->anisotropy = 0.05;
  EXPECT_NEAR(tip_radius(scene) / 0.185, 30., 3.);
  scene.heat->undercooling = 0.;
  EXPECT_EQ(tip_radius(scene), 0.);
}

// A layer from side to side has no arms: its fronts are as long as the domain is high.
TEST(Crystal, ThatIsALayerHasPlaneFronts)
{
  const auto active = [](const std::string &corner, const std::string &size)
  {
    return growth_load(build_world(scene_of("title = \"t\"\n[domain]\nsize = [600.0, 8.0]\n"
                                            "cells = [600, 8]\n[[body]]\nshape = \"rectangle\"\n"
                                            "corner = [" +
                                            corner + "]\nsize = [" + size +
                                            "]\n[clock]\nend = 1.0\n[phase_field]\nwidth = 1.0\n"
                                            "[growth]\nanisotropy = 0.0\ncapillary_length = 0.185\n"
                                            "[heat]\ndiffusivity = 3.0\nundercooling = 0.55\n"),
                                   1))
        .active_nodes;
  };
  const double one = active("0.0, 0.0", "20.0, 8.0"), two = active("290.0, 0.0", "20.0, 8.0");
  EXPECT_GT(one, 8. * 34.); // 17 widths on both sides of it
  EXPECT_NEAR(two, 2. * one, 1e-9 * one);
}

// compress_dendrite_noise in full: 0.29 of the domain when its arms reach the sides, without noise
// half as much.
TEST(Crystal, IsFullerOfSideBranchesWhereNoiseHasRoomForThem)
{
  const std::string noise = "[noise]\nstrength = 1e-3\nseed = 1\n";
  EXPECT_GT(solid_area(crystal(480., noise)), 1.5 * solid_area(crystal(480.)));
  EXPECT_DOUBLE_EQ(solid_area(crystal(60., noise)), solid_area(crystal(60.)));
}
