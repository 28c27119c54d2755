#include <gtest/gtest.h>

#include "grown_scene.h"
#include "solid/energy.h"
#include "solid/splitting.h"

namespace
{
  using namespace solid;

  struct Sums
  {
    double mass = 0., area = 0., plastic = 0., stress = 0.;
    Point momentum = Point::Zero(), centre = Point::Zero();
    explicit Sums(const Solid &solid)
    {
      const Points &p = solid.points;
      for (std::size_t k = 0; k < p.size(); ++k)
      {
        const double m = p.mass[k];
        mass += m, area += m * p.jacobian[k], plastic += m * p.plastic[k];
        stress += m * (p.sxx[k] + 2. * p.syy[k] + 3. * p.sxy[k] + 4. * p.szz[k]);
        momentum += m * Point(p.vx[k], p.vy[k]), centre += m * Point(p.x[k], p.y[k]);
      }
    }
  };

  Owner bar(scene::Scene &scene)
  {
    scene = grown::scene({4., 2.}, {80, 40});
    scene.mpm->split_points = true;
    scene.bodies = {grown::rectangle({1.5, 0.5}, {1., 1.})};
    return make_solid(scene);
  }

  // Stretch about (2, 1) by exp(rate t) along x, its inverse along y; turned by `angle`.
  void impose(Solid &solid, const double strain, const double angle, const int steps)
  {
    Points &points = solid.points;
    const double c = std::cos(2. * angle), s = std::sin(2. * angle);
    for (int k = 0; k < steps; ++k)
    {
      const double h = strain / steps;
      for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Point from(points.x[p] - 2., points.y[p] - 1.);
        points.lxx[p] = c, points.lxy[p] = points.lyx[p] = s, points.lyy[p] = -c;
        points.vx[p] = c * from[0] + s * from[1], points.vy[p] = s * from[0] - c * from[1];
        points.x[p] += h * points.vx[p], points.y[p] += h * points.vy[p];
      }
      stretch(points, h, {0, points.active});
      split_points(solid);
    }
  }
} // namespace

TEST(Splitting, ThreefoldStretchLeavesNoCellInsideWithoutPoints)
{
  for (const double angle : {0., 0.3})
  {
    scene::Scene scene;
    const Owner owner = bar(scene);
    Solid &solid = *owner;
    const long before = points(solid);
    impose(solid, std::log(3.), angle, 400);
    EXPECT_GT(points(solid), before);
    std::vector<int> count(80 * 40, 0);
    for (std::size_t p = 0; p < solid.points.size(); ++p)
      ++count[solid.grid.cell(solid.points.y[p], 1) * 80 + solid.grid.cell(solid.points.x[p], 0)];
    const Point u(std::cos(angle), std::sin(angle));
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 80; ++i)
      {
        const Point x((i + 0.5) * 0.05 - 2., (j + 0.5) * 0.05 - 1.);
        // The initial position of the cell's middle, a cell from the outline.
        const double along = u.dot(x) / 3., across = (u[0] * x[1] - u[1] * x[0]) * 3.;
        const Point X(u[0] * along - u[1] * across, u[1] * along + u[0] * across);
        if (X.cwiseAbs().maxCoeff() < 0.5 - 3. * 0.05)
        {
          ASSERT_GT(count[j * 80 + i], 0) << i << ' ' << j << ' ' << angle;
        }
      }
  }
}

TEST(Splitting, KeepsMassMomentumAndState)
{
  scene::Scene scene;
  const Owner owner = bar(scene);
  Solid &solid = *owner;
  for (std::size_t p = 0; p < solid.points.size(); ++p)
  {
    solid.points.sxx[p] = std::sin(0.1 * p), solid.points.syy[p] = std::cos(0.2 * p);
    solid.points.sxy[p] = 0.3, solid.points.szz[p] = -0.1 * p;
    solid.points.plastic[p] = 0.01 * p, solid.points.jacobian[p] = 1. + 1e-4 * p;
  }
  impose(solid, 0.45, 0.3, 100); // to a factor 1.57: nothing has split yet
  ASSERT_EQ(solid.split_points, 0);
  const Sums before(solid);
  stretch(solid.points, 0.05, {0, solid.points.active});
  split_points(solid);
  const Sums after(solid);
  EXPECT_GT(solid.split_points, 0);
  EXPECT_NEAR(after.mass, before.mass, 1e-12);
  EXPECT_NEAR(after.area, before.area, 1e-12);
  EXPECT_NEAR(after.plastic, before.plastic, 1e-12 * before.plastic);
  EXPECT_NEAR(after.stress, before.stress, 1e-12 * std::abs(before.stress));
  EXPECT_NEAR((after.momentum - before.momentum).norm(), 0., 1e-12);
  EXPECT_NEAR((after.centre - before.centre).norm(), 0., 1e-12);
}

TEST(Splitting, CostsNothingWhereItIsNotAskedFor)
{
  scene::Scene scene = grown::scene({4., 2.}, {80, 40});
  scene.bodies = {grown::rectangle({1.5, 0.5}, {1., 1.})};
  const Owner owner = make_solid(scene);
  EXPECT_TRUE(owner->points.rxx.empty());
  EXPECT_EQ(bytes_per_point(true) - bytes_per_point(), 16u);
  EXPECT_EQ(memory(*owner).at("points"), 1600. * bytes_per_point());
}
