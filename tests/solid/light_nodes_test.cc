// Light nodes follow those behind them, and that takes nothing from momentum, angular momentum or a
// rigid acceleration; what it is for: an elastic cantilever bent far keeps its energy.
#include "solid/light_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "small_scenes.h"
#include "solid/body.h"

namespace
{
  using solid::Point;

  constexpr double floor_part = 0.1;

  // A slanted block after a short step: its rim cuts the cells everywhere unlike.
  solid::Owner slanted()
  {
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, {10., 10.}, {40, 40});
    scene.bodies[0].shape = scene::Polygon{{{{3., 3.}, {7., 4.1}, {6., 7.5}, {2.3, 6.}}}};
    scene.mpm->node_mass_floor = floor_part;
    solid::Owner block = solid::make_solid(scene);
    solid::advance(*block, 1e-6);
    return block;
  }

  struct Sums
  {
    Point momentum = Point::Zero();
    double angular = 0., size = 0.;
  };

  Sums sums(const solid::Grid &grid)
  {
    Sums sums;
    solid::for_each_node(grid,
                         [&](const int i, const int j, const std::ptrdiff_t n)
                         {
                           const Point p =
                               grid.mass[n] * Point(grid.velocity[n].x, grid.velocity[n].y);
                           const Point x(grid.node_x(i), grid.node_y(j));
                           sums.momentum += p, sums.angular += x[0] * p[1] - x[1] * p[0],
                               sums.size += p.norm();
                         });
    return sums;
  }

  void tie(solid::Solid &block, const double dt)
  {
    const double full = block.material.density * block.grid.dx * block.grid.dx;
    solid::tie_light_nodes(block.light_nodes, block.supports, block.grid, floor_part * full, dt, 1);
  }
} // namespace

TEST(LightNodes, AreHeldBackWithoutLossOfMomentum)
{
  const solid::Owner block = slanted();
  solid::Grid &grid = block->grid;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const double dt = 1e-3;
  double light = 0., before = 0.;
  const double least = floor_part * block->material.density * grid.dx * grid.dx;
  // Velocities are those of the forces alone, as large as the grid makes them: f of any node alike.
  for (std::size_t n = 0; n < grid.nodes.size(); ++n)
    if (grid.mass[n] > 0.)
    {
      grid.nodes[n].motion = solid::Quad{0., least * normal(random), 0., least * normal(random)};
      grid.velocity[n] = {dt * grid.nodes[n].force()[0] / grid.mass[n],
                          dt * grid.nodes[n].force()[1] / grid.mass[n]};
      if (grid.mass[n] < 0.1 * least)
        before += std::hypot(grid.velocity[n].x, grid.velocity[n].y);
    }
  const Sums old = sums(grid);
  tie(*block, dt);
  const Sums now = sums(grid);
  for (std::size_t n = 0; n < grid.nodes.size(); ++n)
    if (grid.mass[n] > 0. && grid.mass[n] < 0.1 * least)
      light += std::hypot(grid.velocity[n].x, grid.velocity[n].y);
  EXPECT_LT((now.momentum - old.momentum).norm(), 1e-13 * old.size);
  EXPECT_LT(std::abs(now.angular - old.angular), 1e-11 * old.size);
  EXPECT_GT(before, 0.);
  EXPECT_LT(light, 0.2 * before);
}

TEST(LightNodes, FeelNoLinearAcceleration)
{
  const solid::Owner block = slanted();
  solid::Grid &grid = block->grid;
  const auto given = [&](const int i, const int j)
  {
    const double x = grid.node_x(i), y = grid.node_y(j);
    return Point(1. + 0.2 * x - 0.7 * y, -2. + 0.7 * x + 0.1 * y);
  };
  solid::for_each_node(grid,
                       [&](const int i, const int j, const std::ptrdiff_t n)
                       {
                         const Point a = given(i, j), f = grid.mass[n] * a;
                         grid.nodes[n].motion = solid::Quad{0., f[0], 0., f[1]};
                         grid.velocity[n] = {a[0], a[1]}; // dt = 1
                       });
  tie(*block, 1.);
  double worst = 0.;
  solid::for_each_node(grid,
                       [&](const int i, const int j, const std::ptrdiff_t n)
                       {
                         const Point v(grid.velocity[n].x, grid.velocity[n].y);
                         if (grid.mass[n] > 0.)
                           worst = std::max(worst, (v - given(i, j)).norm());
                       });
  EXPECT_LT(worst, 1e-10);
}

// Four cells high, its end pushed far by a dead load: 0.5 % of the work is gone, 7.6 % without the
// floor.
TEST(LightNodes, KeepTheWorkOfABentCantilever)
{
  const auto lost = [](const double floor)
  {
    scene::Scene scene = small::rectangle({1., 3.}, {6., 1.}, {9., 8.}, {36, 32});
    small::hold(scene, "root", scene::Edge::left, "0", "0");
    scene::Traction load;
    load.name = "end", load.where = scene::Edge::right;
    load.traction = {small::text("0"), small::text("6*smooth(t, 15)")};
    scene.tractions.push_back(load);
    scene.mpm->node_mass_floor = floor;
    const solid::Owner beam = solid::make_solid(scene);
    solid::advance(*beam, 15.);
    const solid::History history = solid::history(*beam);
    return (small::value_of(history, "transfer_loss") +
            small::value_of(history, "energy_balance")) /
           small::value_of(history, "external_work");
  };
  EXPECT_LT(std::abs(lost(0.1)), 0.02);
  EXPECT_GT(lost(0.), 0.05);
}

// Linear functions reach by 0.01 of a cell over the last row of nodes, which by themselves bear a
// step of 0.2 and are tied to bear 0.4; so they must be in the row in front of a clamp, too.
TEST(LightNodes, FollowBesideAClampAsWell)
{
  const auto growth = [](const double floor)
  {
    scene::Scene scene = small::rectangle({1., 1.1275}, {2., 1.}, {4., 4.}, {16, 16});
    small::hold(scene, "root", scene::Edge::left, "0", "0");
    scene.mpm->shape_function = scene::ShapeFunction::linear;
    scene.mpm->points_per_cell = {1, 1};
    scene.mpm->node_mass_floor = floor;
    scene.bodies[0].velocity = {small::text("0"), small::text("0.01*(X - 1)")};
    const solid::Owner beam = solid::make_solid(scene);
    const double given = small::value_of(solid::history(*beam), "kinetic_energy");
    try
    {
      solid::advance(*beam, 1.);
    }
    catch (const std::exception &)
    {
      return HUGE_VAL;
    }
    const solid::History history = solid::history(*beam);
    return (small::value_of(history, "kinetic_energy") +
            small::value_of(history, "elastic_energy")) /
           given;
  };
  EXPECT_LT(growth(0.1), 1.01);
  EXPECT_GT(growth(0.), 2.);
}
