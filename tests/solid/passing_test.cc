// No material point gets past a wall, whichever side it comes from, whatever it holds and however
// long the steps are.
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "grown_scene.h"
#include "solid/walls.h"

namespace
{
  using namespace solid;
  using scene::Edge;

  constexpr double dx = 0.05, size = 2.;

  bool upright(const Edge side)
  {
    return side == Edge::left || side == Edge::right;
  }
  bool upper(const Edge side)
  {
    return side == Edge::right || side == Edge::top;
  }

  /// A rectangle as the wall on `side` sees what the top wall would see of this one.
  scene::Body seen_from(const Edge side, Point corner, Point extent)
  {
    if (upright(side))
      std::swap(corner[0], corner[1]), std::swap(extent[0], extent[1]);
    const int axis = upright(side) ? 0 : 1;
    if (!upper(side))
      corner[axis] = size - corner[axis] - extent[axis];
    return grown::rectangle(corner, extent);
  }

  using Parameters = std::tuple<Edge, scene::WallGrip, double, double>;
  class Passing : public testing::TestWithParam<Parameters>
  {
  };
} // namespace

// It sweeps a crumb along and runs into a block.
TEST_P(Passing, NoPointGetsPastAWall)
{
  const auto [side, grip, step_fraction, mach] = GetParam();
  scene::Scene scene = grown::scene({size, size}, {40, 40});
  scene.solid->yield_stress.reset();
  scene.mpm->step_fraction = step_fraction;
  scene.bodies = {seen_from(side, {0.5, 0.5}, {1., 1.}),
                  seen_from(side, {1.7, 1.5}, {2. * dx, 2. * dx})};
  scene::Wall wall;
  wall.side = side, wall.speed = 0.1, wall.travel = 1., wall.grip = grip;
  scene.walls.push_back(wall);
  const Owner owner = make_solid(scene);
  const double speed = mach * owner->material.wave_speed(), way = 0.6;
  constexpr int calls = 30;
  const double dt = way / speed / calls, inward = upper(side) ? -1. : 1.;
  const Array<double> &x = upright(side) ? owner->points.x : owner->points.y;
  for (int k = 1; k <= calls; ++k)
  {
    const double into = 0.05 + way * k / calls;
    const double position = upper(side) ? size - into : into;
    follow_walls(*owner, {{side, position, inward * speed}}, dt);
    advance(*owner, dt);
    const double nearest =
        inward > 0. ? *std::min_element(x.begin(), x.end()) : *std::max_element(x.begin(), x.end());
    ASSERT_GE((nearest - position) * inward, 0.) << "call " << k;
  }
  EXPECT_EQ(x.size(), 1616u);
}

INSTANTIATE_TEST_SUITE_P(
    Walls, Passing,
    testing::Combine(testing::Values(Edge::left, Edge::right, Edge::bottom, Edge::top),
                     testing::Values(scene::WallGrip::grip, scene::WallGrip::slip),
                     testing::Values(0.4, 1.), testing::Values(0.05, 0.2)));
