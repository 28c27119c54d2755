#include "tall_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "medium/numerical_error.h"
#include "medium/sums.h"

namespace medium
{
  namespace
  {
    scene::Wall piston(Edge side, double speed, double travel)
    {
      scene::Wall wall;
      wall.side = side, wall.speed = speed, wall.travel = travel, wall.start_time = 0.;
      return wall;
    }

    /// Explicit five-point diffusion on the regular stencil, continuation behind the walls filled.
    void diffuse(Field<double> &theta, const Cuts &cuts, const Mesh &mesh, double number)
    {
      fill_behind(theta, cuts, mesh);
      const Field<double> old = theta;
      for (int j = cuts.first(1); j < cuts.end(1, mesh.nodes[1]); ++j)
        for (int i = cuts.first(0); i < cuts.end(0, mesh.nodes[0]); ++i)
          theta(i, j) += number * (old(i + 1, j) + old(i - 1, j) + old(i, j + 1) + old(i, j - 1) -
                                   4. * old(i, j));
    }
  } // namespace

  TEST(Cuts, KeepTheLastLineBetweenHalfAndOneAndAHalfSpacings)
  {
    const Mesh mesh = tall_mesh(8, 60);
    Walls walls = make_walls({piston(Edge::top, 1., 8.), piston(Edge::left, 0.1, 0.5)}, mesh);
    Field<double> phi(mesh, -1.);
    for (int step = 0; step < 300; ++step)
    {
      start_walls(walls, phi, mesh, 0.03 * step);
      move(walls, 0.03 * step, 0.03, mesh);
      update_cuts(walls, mesh, {});
      for (const Edge side : {Edge::top, Edge::left})
      {
        const Cut &cut = *walls.cuts.at(side);
        EXPECT_GE(cut.gap, 0.5 - 1e-9);
        EXPECT_LE(cut.gap, 1.5 + 1e-9);
      }
      EXPECT_NEAR(active_box(walls.cuts, mesh).upper[1], walls.at(Edge::top)->position, 1e-12);
    }
    EXPECT_NEAR(walls.at(Edge::top)->position, 24. - 8., 1e-12);
    EXPECT_EQ(walls.at(Edge::top)->velocity, 0.);
    const Box box = active_box(walls.cuts, mesh);
    EXPECT_NEAR(weighted_sum(Field<double>(mesh, 1.), mesh, walls.cuts) * 0.16,
                (box.upper - box.lower).prod(), 1e-11);
  }

  TEST(Cuts, ContinueAParabolaThatIsLevelAtTheWallExactly)
  {
    const Mesh mesh = tall_mesh(10, 20);
    for (const double gap : {0.5, 0.8, 1.1, 1.49})
      for (const Edge side : {Edge::left, Edge::right, Edge::bottom, Edge::top})
      {
        const int axis = side == Edge::left || side == Edge::right ? 0 : 1;
        const bool high = side == Edge::right || side == Edge::top;
        Cuts cuts;
        cuts.at(side) = Cut{high ? mesh.nodes[axis] - 5 : 4, gap};
        const double wall = cuts.at(side)->last + (high ? gap : -gap);
        const auto value = [&](int k) { return 2. + 0.3 * (k - wall) * (k - wall); };
        const auto slope = [&](int k) { return 0.6 * (k - wall); };
        Field<double> f(mesh), g(mesh);
        for (int j = cuts.first(1); j < cuts.end(1, mesh.nodes[1]); ++j)
          for (int i = cuts.first(0); i < cuts.end(0, mesh.nodes[0]); ++i)
            f(i, j) = value(axis == 0 ? i : j), g(i, j) = slope(axis == 0 ? i : j);
        fill_behind(f, cuts, mesh);
        fill_behind(g, cuts, mesh, axis == 0 ? Parity::odd_in_x : Parity::odd_in_y);
        for (int k = 1; k <= ghost_layers; ++k)
        {
          const int line = cuts.at(side)->last + (high ? k : -k);
          EXPECT_NEAR(axis == 0 ? f(line, 7) : f(6, line), value(line), 1e-12) << gap << " " << k;
          EXPECT_NEAR(axis == 0 ? g(line, 7) : g(6, line), slope(line), 1e-12) << gap << " " << k;
        }
      }
  }

  TEST(Walls, KeepHeatAndWhatTheySwept)
  {
    const Mesh mesh = tall_mesh(12, 60);
    Walls walls = make_walls(
        {piston(Edge::top, 1., 8.), piston(Edge::bottom, 0.7, 5.), piston(Edge::right, 0.11, 0.9)},
        mesh);
    Field<double> theta(mesh), phi(mesh, -1.);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        theta(i, j) = std::sin(0.3 * i) * std::cos(0.11 * j) - 0.01 * j;
    update_cuts(walls, mesh, {{&theta, nullptr, &walls.swept_heat}});
    const double start = weighted_sum(theta, mesh, walls.cuts) * 0.16;
    for (int step = 0; step < 400; ++step)
    {
      start_walls(walls, phi, mesh, 0.02 * step);
      move(walls, 0.02 * step, 0.02, mesh);
      update_cuts(walls, mesh, {{&theta, nullptr, &walls.swept_heat}});
      for (int sub = 0; sub < 3; ++sub)
        diffuse(theta, walls.cuts, mesh, 0.2);
    }
    EXPECT_GT(std::abs(walls.swept_heat), 0.1);
    EXPECT_NEAR(weighted_sum(theta, mesh, walls.cuts) * 0.16 + walls.swept_heat, start, 1e-11);
  }

  TEST(Walls, HaveTheEigenfunctionsOfTheirTruePlace)
  {
    // cos(pi k (y - a)/(b - a)) decays at D (pi k/(b - a))^2, whatever the cut; second order.
    double error[3];
    for (int level = 0; level < 3; ++level)
    {
      const int cells = 40 << level;
      scene::Domain domain;
      domain.size = {4. * 6 / cells, 4.}, domain.cells = {6, cells};
      const Mesh mesh = make_mesh(domain);
      const double h = mesh.spacing[0], low = 0.53, high = 3.391;
      Cuts cuts;
      const int top = static_cast<int>(std::floor(high / h - 0.5)),
                bottom = static_cast<int>(std::ceil(low / h + 0.5));
      cuts.at(Edge::top) = Cut{top, high / h - top};
      cuts.at(Edge::bottom) = Cut{bottom, bottom - low / h};
      const double k = 2. * M_PI / (high - low);
      Field<double> theta(mesh);
      for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= 6; ++i)
          theta(i, j) = std::cos(k * (j * h - low));
      const int steps = 200 << (2 * level);
      for (int step = 0; step < steps; ++step)
        diffuse(theta, cuts, mesh, 0.05);
      const double time = 0.05 * h * h * steps;
      error[level] = 0.;
      for (int j = bottom; j <= top; ++j)
        error[level] =
            std::max(error[level],
                     std::abs(theta(3, j) - std::exp(-k * k * time) * std::cos(k * (j * h - low))));
    }
    EXPECT_LT(error[2], 1e-3);
    EXPECT_GT(0.5 * std::log2(error[0] / error[2]), 1.7);
  }

  TEST(Walls, AdvectWhatRestsOnThemAlongWithThem)
  {
    // All of the melt moves with the bottom wall over more than 20 cells: seen from the wall,
    // nothing happens. Velocity is that of the wall everywhere; the far end stays uniform.
    const Mesh mesh = tall_mesh(8, 120);
    const double speed = 0.5;
    Walls walls = make_walls({piston(Edge::bottom, speed, 9.)}, mesh);
    const auto profile = [](double above)
    { return std::tanh((6. - above) / std::sqrt(2.)) + 0.2 * std::exp(-above * above / 9.); };
    Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        phi(i, j) = profile(0.4 * j);
    Gradients gradients;
    Advection advection(mesh, scene::AdvectionScheme::cip);
    const double dt = 0.1;
    for (int step = 0; step < 180; ++step)
    {
      start_walls(walls, phi, mesh, step * dt);
      move(walls, step * dt, dt, mesh);
      Velocity velocity(mesh);
      velocity.y = Field<double>(mesh, walls.walls[0].velocity);
      fill_behind(velocity, walls, mesh);
      advection.advect(phi, gradients, velocity, dt);
      update_cuts(walls, mesh, {{&phi, &gradients, nullptr}});
    }
    const Wall &wall = walls.walls[0];
    EXPECT_NEAR(wall.travel, 9., 1e-9);
    double error = 0.;
    for (int j = walls.cuts.first(1); j < mesh.nodes[1] - 30; ++j)
      error = std::max(error, std::abs(phi(3, j) - profile(0.4 * j - wall.position)));
    EXPECT_LT(error, 8e-3); // 0.03 dx of the front
  }

  TEST(Walls, AreRefusedWhereTheyCannotStand)
  {
    const Mesh mesh = tall_mesh(20, 40);
    EXPECT_THROW(make_walls({piston(Edge::top, 1., 2.), piston(Edge::top, 1., 2.)}, mesh),
                 std::invalid_argument);
    EXPECT_THROW(make_walls({piston(Edge::top, 1., 8.), piston(Edge::bottom, 1., 8.)}, mesh),
                 std::invalid_argument);
    Mesh periodic = mesh;
    periodic.boundary.fill(Boundary::periodic);
    EXPECT_THROW(make_walls({piston(Edge::top, 1., 2.)}, periodic), std::invalid_argument);
    Walls walls = make_walls({piston(Edge::top, 1., 2.)}, mesh);
    start_walls(walls, Field<double>(mesh, -1.), mesh, 0.);
    try
    {
      move(walls, 0., 0.3, mesh);
      FAIL() << "it crossed most of a cell";
    }
    catch (const NumericalError &trouble)
    {
      EXPECT_NE(std::string(trouble.what()).find("a wall crosses"), std::string::npos)
          << trouble.what();
    }
  }
} // namespace medium
