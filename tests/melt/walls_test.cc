#include "medium/walls.h"

#include <gtest/gtest.h>
#include <omp.h>

#include "medium/sums.h"
#include "melt/heat_budget.h"
#include "melt/noise.h"
#include "seed.h"

namespace
{
  using medium::Edge;
  using melt::Growth;
  using melt::GrowthOptions;
  using test::Boundary;
  using test::Field;
  using test::Mesh;

  scene::Wall piston(Edge side, double speed, double travel)
  {
    scene::Wall wall;
    wall.side = side, wall.speed = speed, wall.travel = travel, wall.start_time = 0.;
    return wall;
  }

  double heat(const test::Melt &melt, const Mesh &mesh, const medium::Walls &walls)
  {
    const double area = mesh.spacing.prod();
    return area * (medium::weighted_sum(melt.theta, mesh, walls.cuts) -
                   0.5 * medium::weighted_sum(melt.phi, mesh, walls.cuts)) +
           walls.swept_heat - 0.5 * walls.swept_phase;
  }

  /// A seed between three walls that close in on it; noise included. No advection.
  test::Melt squeezed(const Mesh &mesh, medium::Walls &walls, const GrowthOptions &options)
  {
    test::Melt melt = test::seeded(mesh, {16., 14.}, 5., 0.55);
    const melt::Noise noise(mesh, {1e-3, 3., 5, false});
    Growth growth(mesh, test::paper_law(0.05), options, 0.55);
    const double dt = 4. * growth.step_limit() * 0.8;
    for (int step = 0; step < 150; ++step)
    {
      medium::start_walls(walls, melt.phi, mesh, step * dt);
      medium::move(walls, step * dt, dt, mesh);
      medium::update_cuts(
          walls, mesh,
          {{&melt.phi, nullptr, &walls.swept_phase}, {&melt.theta, nullptr, &walls.swept_heat}});
      growth.advance({&melt.phi, &melt.theta, nullptr, &noise, &walls.cuts}, dt / 4., 4);
    }
    return melt;
  }

  std::vector<scene::Wall> three_walls()
  {
    return {piston(Edge::top, 1., 7.), piston(Edge::bottom, 0.6, 4.), piston(Edge::left, 0.9, 6.)};
  }

  /// Height of the front above the bottom wall after some growth into the melt that rests on it;
  /// the wall and all melt move with `speed`.
  double front_above_wall(double speed, double end, double &cells_moved)
  {
    Mesh mesh = test::square_mesh(7, 0.4, Boundary::no_flux);
    mesh.nodes[1] = 301;
    medium::Walls walls =
        medium::make_walls({piston(Edge::bottom, speed, 1e-9 + speed * end)}, mesh);
    test::Melt melt{Field<double>(mesh), Field<double>(mesh, -0.8)};
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        melt.phi(i, j) = std::tanh((3. - 0.4 * j) / std::sqrt(2.));
    Growth growth(mesh, test::paper_law(0.), GrowthOptions{}, 0.8);
    medium::Advection advection(mesh, scene::AdvectionScheme::cip);
    medium::Gradients of_phi, of_theta;
    const double dt = 0.1;
    for (int step = 0; step * dt < end - 1e-9; ++step)
    {
      medium::start_walls(walls, melt.phi, mesh, step * dt);
      medium::move(walls, step * dt, dt, mesh);
      if (walls.moving())
      {
        medium::Velocity velocity(mesh);
        velocity.y = Field<double>(mesh, walls.walls[0].velocity);
        medium::fill_behind(velocity, walls, mesh);
        advection.advect(melt.phi, of_phi, velocity, dt);
        advection.advect(melt.theta, of_theta, velocity, dt);
        medium::update_cuts(walls, mesh,
                            {{&melt.phi, &of_phi, nullptr}, {&melt.theta, &of_theta, nullptr}});
      }
      growth.advance({&melt.phi, &melt.theta, nullptr, nullptr, &walls.cuts}, dt / 10., 10);
    }
    cells_moved = walls.walls[0].travel / 0.4;
    int j = walls.cuts.first(1);
    while (melt.phi(3, j + 1) > 0.)
      ++j;
    const double above = std::atanh(melt.phi(3, j)), below = std::atanh(melt.phi(3, j + 1));
    return 0.4 * (j + above / (above - below)) - walls.walls[0].position;
  }
} // namespace

TEST(GrowthBetweenWalls, KeepsHeatWithWhatTheWallsSwept)
{
  const Mesh mesh = test::square_mesh(80, 0.4, Boundary::no_flux);
  for (const auto laplacian : {scene::Laplacian::five_point, scene::Laplacian::nine_point})
  {
    GrowthOptions options;
    options.laplacian = laplacian;
    medium::Walls walls = medium::make_walls(three_walls(), mesh), before = walls;
    const double start = heat(test::seeded(mesh, {16., 14.}, 5., 0.55), mesh, before);
    const test::Melt melt = squeezed(mesh, walls, options);
    EXPECT_GT(std::abs(walls.swept_heat), 10.);
    EXPECT_NEAR(heat(melt, mesh, walls) / start, 1., 1e-12);
  }
}

TEST(GrowthBetweenWalls, HasTheSameBitsWithAndWithoutThreadsAndNearlyWithoutTiles)
{
  const Mesh mesh = test::square_mesh(80, 0.4, Boundary::no_flux);
  GrowthOptions options;
  medium::Walls first = medium::make_walls(three_walls(), mesh), second = first, third = first;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const test::Melt one = squeezed(mesh, first, options);
  omp_set_num_threads(3);
  const test::Melt three = squeezed(mesh, second, options);
  omp_set_num_threads(before);
  options.tiles = false;
  const test::Melt all = squeezed(mesh, third, options);
  EXPECT_EQ(test::largest_difference(one.phi, three.phi, mesh), 0.);
  EXPECT_EQ(test::largest_difference(one.theta, three.theta, mesh), 0.);
  EXPECT_LT(test::largest_difference(one.phi, all.phi, mesh), 1e-8);
}

TEST(GrowthBetweenWalls, IsGalilean)
{
  double at_rest_cells = 0., moved_cells = 0.;
  const double end = 30.;
  const double at_rest = front_above_wall(0., end, at_rest_cells),
               moved = front_above_wall(0.3, end, moved_cells);
  EXPECT_GT(moved_cells, 20.);
  EXPECT_GT(at_rest, 10.); // it has grown
  EXPECT_NEAR(moved, at_rest, 0.1 * 0.4);
}
