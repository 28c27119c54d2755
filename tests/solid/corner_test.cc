#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "grown_scene.h"
#include "solid/moving_walls.h"
#include "solid/walls.h"

using namespace solid;
using scene::Edge;

// Each of two walls that meet holds its own way across; neither undoes the other's push.
TEST(Walls, MeetingInACornerPressAlike)
{
  scene::Scene scene = grown::scene({2., 2.}, {40, 40});
  scene.solid->yield_stress.reset();
  scene.bodies = {grown::rectangle({0., 0.}, {1., 1.})};
  for (const Edge side : {Edge::left, Edge::bottom})
  {
    scene::Wall wall;
    wall.side = side, wall.speed = 0.1, wall.travel = 0.2, wall.grip = scene::WallGrip::grip;
    scene.walls.push_back(wall);
  }
  const Owner owner = make_solid(scene);
  constexpr int steps = 100;
  constexpr double end = 0.5, speed = 0.05;
  for (int k = 0; k < steps; ++k)
  {
    const double dt = end / steps, at = speed * (k + 1) * dt;
    set_wall_motions(*owner, {{Edge::left, at, speed}, {Edge::bottom, at, speed}}, dt);
    advance(*owner, dt);
  }
  const Point left = reaction(*owner, wall_name(Edge::left)).impulse;
  const Point bottom = reaction(*owner, wall_name(Edge::bottom)).impulse;
  EXPECT_GT(left[0], 0.);
  EXPECT_NEAR(left[0], bottom[1], 1e-6 * left[0]);
  EXPECT_NEAR(left[1], bottom[0], 1e-6 * left[0]);
  for (std::size_t p = 0; p < owner->points.size(); ++p)
    EXPECT_GT(std::min(owner->points.x[p], owner->points.y[p]), speed * end - 1e-9);
}

// A slipping wall that pushes beside one that grips: the order of the two in the scene says
// nothing.
TEST(Walls, PushAlikeInEitherOrder)
{
  std::array<double, 2> force{};
  for (int order = 0; order < 2; ++order)
  {
    scene::Scene scene = grown::scene({1.5, 1.2}, {30, 24});
    scene.solid->yield_stress.reset();
    scene.bodies = {grown::rectangle({0., 0.}, {1., 1.})};
    std::vector<Edge> sides{Edge::left, Edge::bottom, Edge::top};
    if (order == 1)
      std::reverse(sides.begin(), sides.end());
    for (const Edge side : sides)
    {
      scene::Wall wall;
      wall.side = side;
      wall.grip = side == Edge::top ? scene::WallGrip::slip : scene::WallGrip::grip;
      if (side == Edge::top)
        wall.speed = 0.05, wall.travel = 1.;
      scene.walls.push_back(wall);
    }
    const Owner owner = make_solid(scene);
    constexpr int steps = 100;
    constexpr double end = 0.4, speed = 0.05;
    for (int k = 0; k < steps; ++k)
    {
      const double dt = end / steps, top = 1. - speed * (k + 1) * dt;
      set_wall_motions(
          *owner, {{Edge::left, 0., 0.}, {Edge::bottom, 0., 0.}, {Edge::top, top, -speed}}, dt);
      advance(*owner, dt);
    }
    force[static_cast<std::size_t>(order)] = -reaction(*owner, wall_name(Edge::top)).impulse[1];
  }
  EXPECT_GT(force[0], 0.);
  EXPECT_NEAR(force[0], force[1], 1e-9 * force[0]);
}
