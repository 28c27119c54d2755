// Few points a cell in a body that is strained elastically and moves: the program says so itself.
#include <cmath>

#include <gtest/gtest.h>

#include "quadrature.h"
#include "written_scene.h"

namespace
{
  // Cells of 0.25; the material is driven as a whole, so that its stress stays.
  std::string said(const double stress, const double moved, const std::string &points)
  {
    const scene::Scene scene = scene_of(
        "[domain]\nsize = [4.0, 2.0]\ncells = [16, 8]\n"
        "[[body]]\nshape = \"rectangle\"\ncorner = [0.5, 0.5]\nsize = [1.0, 1.0]\n"
        "initial_stress = [\"0\", \"0\", \"0\", \"" +
        std::to_string(stress / std::sqrt(3.)) +
        "\"]\n[solid]\nyoung_modulus = 1e3\npoisson_ratio = 0.3\ndensity = 1.0\n"
        "[[support]]\nregion = {lower = [0.4, 0.4], upper = [1.6, 1.6]}\ndisplacement = [\"" +
        std::to_string(moved) +
        "*t + 1e-9*t*X\", \"0\"]\n[clock]\nend = 1.0\n[mpm]\npoints_per_cell = " + points + "\n");
    World world = build_world(scene, 1);
    solid::advance(*world.solid, 1.);
    return warning_on_quadrature(world);
  }
} // namespace

TEST(Quadrature, IsDoubtedWhereFewPointsCarryElasticStrainOverCells)
{
  EXPECT_NE(said(20., 1., "[2, 2]").find("2 % in the mean, moved over 4 cells with 2 x 2"),
            std::string::npos);
  EXPECT_EQ(said(20., 1., "[4, 4]"), "");
  EXPECT_EQ(said(20., 0.5, "[2, 2]"), "");
  EXPECT_EQ(said(8., 1., "[2, 2]"), "");
}

TEST(Quadrature, IsDoubtedInBodiesThinnerThanTwoCells)
{
  const auto about = [](const double width)
  {
    const scene::Scene scene = scene_of(
        "[domain]\nsize = [8.0, 2.0]\ncells = [32, 8]\n"
        "[[body]]\nname = \"strip\"\nshape = \"rectangle\"\ncorner = [0.5, 0.5]\nsize = [7.0, " +
        std::to_string(width) +
        "]\n[solid]\nyoung_modulus = 1e3\npoisson_ratio = 0.3\ndensity = 1.0\n"
        "[clock]\nend = 1.0\n");
    return warning_on_thin_bodies(build_world(scene, 1));
  };
  EXPECT_NE(about(0.25).find("\"strip\" is about 0.97 cells wide"), std::string::npos);
  EXPECT_EQ(about(0.75), "");
}

TEST(Quadrature, TakesAQuarterForTheWholeBodyThatItStandsFor)
{
  const scene::Scene scene =
      scene_of("[domain]\nsize = [2.0, 2.0]\ncells = [8, 8]\nboundary = \"symmetry\"\n"
               "[[body]]\nname = \"disc\"\nshape = \"disc\"\ncentre = [0.0, 0.0]\n"
               "radius = 0.6\n[solid]\nyoung_modulus = 1e3\npoisson_ratio = 0.3\n"
               "density = 1.0\n[clock]\nend = 1.0\n"); // 2.4 cells of radius: 2.4 wide in the mean
  EXPECT_EQ(warning_on_thin_bodies(build_world(scene, 1)), "");
}
