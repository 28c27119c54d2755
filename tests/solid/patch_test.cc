// A strip with free sides, stretched: uniform in the continuum. What the points make of it.
//
// Stresses scatter about the right mean by an amount that quadrature explains. Points a distance
// delta apart (in cells) integrate the derivative of a shape function, whose integral is zero, with
// the error of their first harmonic (Poisson's sum),
//   sum_p delta N'(x_p - x_i) = 2 w |sinc(w/2)|^3 cos(w i + const),   w = 2 pi/delta,
// zero when a cell is a whole number of spacings. Equilibrium of the nodes answers with a stress of
// the wave number k, w folded into [-pi, pi], which the same functions pass on as k sinc^3(k/2). So
// the scatter depends on the spacing of the stretched points, not on the cells' size, and not on
// the sides: across the strip all terms are the same factor.
#include <gtest/gtest.h>

#include <cmath>

#include "small_scenes.h"

namespace
{
  using scene::Edge;
  constexpr double pi = 3.14159265358979323846;

  struct Strip
  {
    scene::Point corner{0.6, 0.4}, size{2.0, 0.8}; // on grid lines
    double stretch = 1.05;
    int points_per_cell = 2, refinement = 1;
  };

  solid::Owner stretched(const Strip &strip)
  {
    scene::Scene scene = small::rectangle(strip.corner, strip.size, {4., 2.},
                                          {20 * strip.refinement, 10 * strip.refinement});
    scene.mpm->points_per_cell = {strip.points_per_cell, strip.points_per_cell};
    const double longer = (strip.stretch - 1.) * strip.size[0];
    const auto moving = [](const double by) { return std::to_string(by) + "*smooth(t, 4)"; };
    small::hold(scene, "left", Edge::left, moving(-longer / 6.), std::nullopt);
    small::hold(scene, "right", Edge::right, moving(longer * 5. / 6.), std::nullopt);
    solid::Owner solid = solid::make_solid(scene);
    solid::advance(*solid, 5.);
    return solid;
  }

  double mean(const solid::Solid &solid, const std::string &of)
  {
    return solid::region_means(solid, scene::RegionProbe{}, {of})[0];
  }

  // E/(1 - nu^2) times the logarithmic strain.
  double stress_at(const double stretch)
  {
    return 1000. / 0.91 * std::log(stretch);
  }

  // Root mean square of the points' stress about the uniform one, relative.
  double scatter(const Strip &strip)
  {
    const solid::Owner solid = stretched(strip);
    const record::Snapshot points = solid::snapshot(*solid, {"stress_xx"});
    double squares = 0.;
    for (const double s : points.fields.at("stress_xx"))
      squares += std::pow(s / stress_at(strip.stretch) - 1., 2);
    return std::sqrt(squares / static_cast<double>(points.vertex.size()));
  }

  double predicted_scatter(const Strip &strip)
  {
    const auto transferred = [](const double w)
    { return w * std::pow(2. / w * std::sin(w / 2.), 3); };
    const double w = 2. * pi * strip.points_per_cell / strip.stretch;
    const double k = std::remainder(w, 2. * pi);
    return std::abs(2. * transferred(w) / transferred(k)) / std::sqrt(2.);
  }
} // namespace

// Both ends move off the grid, points stand off the cell centres and cross cells.
TEST(Patch, StretchedStripHasTheRightMeans)
{
  const Strip asked{{0.53, 0.47}, {2.03, 0.83}, 1. + 0.3 / 2.03};
  const solid::Owner strip = stretched(asked);
  const double strain = std::log(asked.stretch), stress = stress_at(asked.stretch);
  EXPECT_NEAR(mean(*strip, "stress_xx") / stress, 1., 0.005);
  EXPECT_NEAR(mean(*strip, "stress_yy") / stress, 0., 0.005);
  EXPECT_NEAR(mean(*strip, "log_strain_xx"), strain, 0.005 * strain);
  // The sides have moved in: force = stress times the width now.
  solid::advance(*strip, 0.5);
  const double width = 0.83 * std::exp(-0.3 / 0.7 * strain);
  EXPECT_NEAR(solid::reaction(*strip, "right").force[0] / (stress * width), 1., 0.01);
  EXPECT_NEAR(solid::reaction(*strip, "left").force[0] / (stress * width), -1., 0.01);
}

TEST(Patch, SidesThatCutCellsAddNoScatter)
{
  Strip on_lines, cut;
  cut.corner[1] = 0.47, cut.size[1] = 0.83;
  const double expected = scatter(on_lines);
  EXPECT_NEAR(scatter(cut), expected, 0.02 * expected);
}

TEST(Patch, ScatterIsTheQuadratureErrorOfStretchedSpacings)
{
  // The first harmonic alone, and of the last spacing alone: within a factor of two over two
  // orders of magnitude.
  for (const auto &[stretch, points] : {std::pair{1.015, 2}, {1.05, 2}, {1.15, 2}, {1.15, 4}})
  {
    Strip strip;
    strip.stretch = stretch, strip.points_per_cell = points;
    const double ratio = scatter(strip) / predicted_scatter(strip);
    EXPECT_GT(ratio, 0.5) << stretch << ", " << points << " points";
    EXPECT_LT(ratio, 2.) << stretch << ", " << points << " points";
  }
}

TEST(Patch, ScatterFallsWithPointsPerCellNotWithCells)
{
  Strip strip;
  strip.stretch = 1.15;
  const double two = scatter(strip);
  strip.points_per_cell = 8;
  EXPECT_LT(scatter(strip), 0.02 * two);
  strip.points_per_cell = 2, strip.refinement = 2;
  EXPECT_GT(scatter(strip), 0.5 * two);
}

// A block that is driven as a whole and hardly strained, its points at pressures that alternate
// within each cell: each step takes a tenth of what is left of the difference, and the means stay
// (weighted with volumes, which pressure changes: it is stiff).
TEST(AntiLocking, BringsThePressuresOfACellTogether)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  scene.mpm->points_per_cell = {2, 2}, scene.mpm->anti_locking = true;
  scene.solid->young_modulus = 1e9;
  const auto pressure = small::text("2 + cos(2*pi*(X - 0.05)/0.2)"); // 3 and 1 by columns
  scene.bodies[0].initial_stress = {pressure, pressure, pressure, small::text("0")};
  small::hold(scene, "all", scene::Box{{0.9, 0.9}, {2.1, 2.1}}, "1e-12*t*X", "0");
  const solid::Owner block = solid::make_solid(scene);
  const double step = solid::stable_step(*block);
  for (int k = 0; k < 5; ++k)
    solid::advance(*block, step);
  ASSERT_EQ(solid::steps(*block), 5);
  const record::Snapshot points = solid::snapshot(*block, {"stress_zz"});
  double least = 9., most = -9.;
  for (const double stress : points.fields.at("stress_zz"))
    least = std::min(least, stress), most = std::max(most, stress);
  EXPECT_NEAR(most, 2. + std::pow(0.9, 5), 1e-8);
  EXPECT_NEAR(least, 2. - std::pow(0.9, 5), 1e-8);
}
