// Outlines of joined and cut bodies lie on the edges of the bodies and on the symmetry sides.
#include <cmath>

#include <gtest/gtest.h>

#include "body.h"

#include "scene/geometry.h"

using scene::Body;
using scene::Point;
using scene_test::body;

namespace
{
  scene::Domain above_the_axis()
  {
    scene::Domain domain;
    domain.lower = {-2., 0.}, domain.size = {4., 2.}, domain.cells = {80, 40};
    domain.boundary = {scene::Boundary::no_flux, scene::Boundary::no_flux,
                       scene::Boundary::symmetry, scene::Boundary::no_flux};
    return domain;
  }

  // Length of the outline on y = 0, to the last digit there.
  double length_on_axis(const std::vector<scene::Polyline> &lines)
  {
    double length = 0.;
    for (const scene::Polyline &line : lines)
      for (std::size_t k = 0; k < line.size(); ++k)
      {
        const Point &a = line[k], &b = line[(k + 1) % line.size()];
        if (a[1] == 0. && b[1] == 0.)
          length += std::abs(b[0] - a[0]);
      }
    return length;
  }
} // namespace

TEST(ExactVertices, OfADiscLieOnTheSymmetrySideThatCutsIt)
{
  const auto lines = scene::outline({body(scene::Disc{{0.01, 0.3}, 1.})}, above_the_axis(), 0.05);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(length_on_axis(lines), 2. * std::sqrt(1. - 0.09), 2e-3); // a chord's sagitta
  for (const Point &p : lines[0])
    EXPECT_GE(p[1], 0.);
}

TEST(ExactVertices, OfASlantedPolygonLieOnTheSymmetrySideThatCutsIt)
{
  const Body slanted =
      body(scene::Polygon{{{{-1.013, -0.51}, {1.13, -0.37}, {0.77, 1.5}, {-0.61, 1.5}}}});
  const auto lines = scene::outline({slanted}, above_the_axis(), 0.05);
  ASSERT_EQ(lines.size(), 1u);
  const double left = -1.013 + 0.403 * 0.51 / 2.01, right = 1.13 - 0.36 * 0.37 / 1.87;
  EXPECT_NEAR(length_on_axis(lines), right - left, 1e-13);
}

TEST(ExactVertices, OfAUnionLieOnTheStraightEdgesOfItsBodies)
{
  const auto lines = scene::outline(
      {body(scene::Rectangle{{0., 0.}, {2., 1.}}), body(scene::Disc{{1.03, 0.013}, 0.4})}, 0.025);
  ASSERT_EQ(lines.size(), 1u);
  const double half = std::sqrt(0.16 - 0.013 * 0.013);
  EXPECT_NEAR(length_on_axis(lines), 2. - 2. * half, 1e-3);
}
