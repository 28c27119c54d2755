// No material point gets past a wall, whichever side it comes from, whatever it holds and however
// long the steps are.
#include <algorithm>
#include <cmath>
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

  Edge opposite(const Edge side)
  {
    return upright(side) ? (upper(side) ? Edge::left : Edge::right)
                         : (upper(side) ? Edge::bottom : Edge::top);
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

  using Parameters = std::tuple<Edge, scene::WallGrip, double>; // the last: mpm.step_fraction
  class Passing : public testing::TestWithParam<Parameters>
  {
  protected:
    scene::Scene scene = grown::scene({size, size}, {40, 40});
    Edge side = std::get<Edge>(GetParam());
    double inward = upper(side) ? -1. : 1.;

    Passing()
    {
      scene.solid->yield_stress.reset();
      scene.mpm->step_fraction = std::get<double>(GetParam());
      scene::Wall wall;
      wall.side = side, wall.speed = 0.1, wall.travel = 1.;
      wall.grip = std::get<scene::WallGrip>(GetParam());
      scene.walls.push_back(wall);
      wall.side = opposite(side); // at rest: nothing is to get out of the domain
      scene.walls.push_back(wall);
    }

    /// The wall goes from 0.05 before its side of the domain by `way`, at `mach` times the wave
    /// speed.
    void press(const double mach, const double way)
    {
      const Owner owner = make_solid(scene);
      const double speed = mach * owner->material.wave_speed();
      constexpr int calls = 30;
      const double dt = way / speed / calls;
      const Array<double> &x = upright(side) ? owner->points.x : owner->points.y;
      const std::size_t count = x.size();
      for (int k = 1; k <= calls; ++k)
      {
        const double into = 0.05 + way * k / calls;
        const double position = upper(side) ? size - into : into;
        const double other = upper(side) ? 0. : size;
        set_wall_motions(*owner, {{side, position, inward * speed}, {opposite(side), other, 0.}},
                         dt);
        advance(*owner, dt);
        const double nearest = inward > 0. ? *std::min_element(x.begin(), x.end())
                                           : *std::max_element(x.begin(), x.end());
        ASSERT_GE((nearest - position) * inward, 0.) << "call " << k;
      }
      EXPECT_EQ(x.size(), count);
    }
  };
} // namespace

// It sweeps a crumb along and runs into a block.
TEST_P(Passing, NoPointGetsPastAWall)
{
  scene.bodies = {seen_from(side, {0.5, 0.5}, {1., 1.}),
                  seen_from(side, {1.7, 1.5}, {2. * dx, 2. * dx})};
  for (const double mach : {0.05, 0.2})
    press(mach, 0.6);
}

// Without being put back some of these points would be half a cell behind it.
TEST_P(Passing, NoPointIsThrownPastAWall)
{
  scene.mpm->points_per_cell = {3, 3};
  const double wave_speed = std::sqrt(1e4 * 0.67 / (1.33 * 0.34));
  for (int k = 0; k < 5; ++k)
  {
    scene.bodies.push_back(seen_from(side, {0.2 + 0.31 * k, 1.2 + 0.083 * k}, {2. * dx, 2. * dx}));
    scene.bodies.back().velocity[upright(side) ? 0 : 1].text =
        std::to_string(-inward * 0.3 * wave_speed);
  }
  press(0.05, 0.6);
}

INSTANTIATE_TEST_SUITE_P(
    Walls, Passing,
    testing::Combine(testing::Values(Edge::left, Edge::right, Edge::bottom, Edge::top),
                     testing::Values(scene::WallGrip::grip, scene::WallGrip::slip),
                     testing::Values(0.4, 1.)));
