#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "grown_scene.h"
#include "solid/energy.h"
#include "solid/state_check.h"
#include "solid/walls.h"

namespace
{
  using namespace solid;
  using scene::Edge;

  constexpr double dx = 0.05;

  double smooth(const double s)
  {
    return s < 0. ? 0. : s > 1. ? 1. : s * s * (3. - 2. * s);
  }

  // An elastic block of 1 x 1 with its lower left corner at `corner`, and walls below and above it.
  scene::Scene block(const scene::WallGrip grip, const Point &corner = {0.5, 0.5})
  {
    scene::Scene scene = grown::scene({2., 2.}, {40, 40});
    scene.solid->yield_stress.reset();
    scene.bodies = {grown::rectangle(corner, {1., 1.})};
    for (const Edge side : {Edge::bottom, Edge::top})
    {
      scene::Wall wall;
      wall.side = side, wall.speed = 0.1, wall.travel = 1., wall.grip = grip;
      scene.walls.push_back(wall);
    }
    return scene;
  }

  struct Press
  {
    scene::Scene scene;
    Owner owner;
    Solid &solid;
    std::map<Edge, double> position;

    explicit Press(const scene::Scene &asked)
        : scene(asked), owner(make_solid(scene)), solid(*owner)
    {
      position = {{Edge::bottom, 0.}, {Edge::top, 2.}};
    }
    double force(const Edge side) const { return reaction(solid, wall_name(side)).force[1]; }
    // Walls to target(side, s), s from 0 to 1 over `transits` of the block's height; after each of
    // `calls` look(s).
    template <typename Target, typename Look>
    void move(const double transits, const int calls, Target &&target, Look &&look)
    {
      const double dt = transits / solid.material.wave_speed() / calls;
      for (int k = 1; k <= calls; ++k)
      {
        std::vector<WallMotion> motions;
        for (auto &[side, now] : position)
        {
          const double next = target(side, double(k) / calls);
          motions.push_back({side, next, (next - now) / dt}), now = next;
        }
        set_wall_motions(solid, motions, dt);
        advance(solid, dt);
        look(double(k) / calls);
      }
    }
    template <typename Target>
    void move(const double transits, const int calls, Target &&target)
    {
      move(transits, calls, target, [](double) {});
    }
    void close(const double bottom, const double top)
    {
      position = {{Edge::bottom, bottom}, {Edge::top, top}};
    }
  };

  // Both walls in by half of `strain` of the unit height.
  auto squeeze(const double strain)
  {
    return [=](const Edge side, const double s)
    { return side == Edge::top ? 1.5 - 0.5 * strain * smooth(s) : 0.5 + 0.5 * strain * smooth(s); };
  }

  double plane_strain_modulus(const Solid &solid)
  {
    return solid.material.young / (1. - solid.material.poisson * solid.material.poisson);
  }
} // namespace

// A block of points names the first that went wrong. A wall mends that one, not those behind it.
TEST(Walls, MendOnePointAndHideNoOther)
{
  Press press(block(scene::WallGrip::slip));
  Solid &solid = press.solid;
  solid.shares.assign(1, Share{});
  solid.shares[0].bad = 0;
  solid.points.y[0] = 2. + 0.1 * dx;
  const double dt = 0.1 * dx / solid.material.wave_speed();
  EXPECT_NO_THROW(check_state(solid, dt));
  EXPECT_LT(solid.points.y[0], 2.);
  solid.points.y[0] = 2. + 0.1 * dx;
  solid.points.vx[5] = dx / dt;
  try
  {
    check_state(solid, dt);
    FAIL() << "it went on";
  }
  catch (const NumericalError &trouble)
  {
    EXPECT_NE(std::string(trouble.what()).find("crosses half a cell"), std::string::npos)
        << trouble.what();
  }
}

TEST(Walls, SlippingOnesPressABlockUniformly)
{
  Press press(block(scene::WallGrip::slip));
  press.close(0.5, 1.5);
  press.move(40., 40, squeeze(0.01));
  const double stress = plane_strain_modulus(press.solid) * -std::log(1. - 0.01);
  const double width = 1. + 0.33 / 0.67 * 0.01;
  EXPECT_NEAR(press.force(Edge::bottom), stress * width, 0.02 * stress);
  EXPECT_NEAR(press.force(Edge::top), -stress * width, 0.02 * stress);
  EXPECT_LT(quasi_static(press.solid, {1., 0.1}).force_imbalance, 0.01);
  for (std::size_t p = 0; p < press.solid.points.size(); ++p)
  {
    ASSERT_NEAR(press.solid.points.syy[p], -stress, 0.03 * stress);
    ASSERT_NEAR(press.solid.points.sxx[p], 0., 0.03 * stress);
  }
}

TEST(Walls, PassingNodesKeepTheForceSmooth)
{
  Press press(block(scene::WallGrip::slip, {0.5, 0.7}));
  press.close(0.7, 1.7);
  press.move(40., 40,
             [](const Edge side, const double s) {
               return (side == Edge::top ? 1.7 : 0.7) - (side == Edge::top ? 0.01 * smooth(s) : 0.);
             });
  const double start = press.force(Edge::bottom);
  double lowest = start, highest = start;
  press.move(
      100., 100,
      [](const Edge side, const double s)
      { return (side == Edge::top ? 1.69 : 0.7) - 2.5 * dx * smooth(s); },
      [&](double)
      {
        const double force = press.force(Edge::bottom);
        lowest = std::min(lowest, force), highest = std::max(highest, force);
      });
  RecordProperty("lowest", std::to_string(lowest / start));
  RecordProperty("highest", std::to_string(highest / start));
  EXPECT_GT(lowest, 0.96 * start);
  EXPECT_LT(highest, 1.04 * start);
}

TEST(Walls, SlippingOnesNeverPull)
{
  Press press(block(scene::WallGrip::slip));
  press.close(0.5, 1.5);
  press.move(40., 40, squeeze(0.004));
  press.move(40., 40,
             [](const Edge side, const double s)
             { return side == Edge::top ? 1.498 + 0.1 * smooth(s) : 0.502; });
  const double stress = 0.004 * plane_strain_modulus(press.solid);
  double largest = -stress;
  press.move(
      10., 10, [](const Edge side, double) { return side == Edge::top ? 1.598 : 0.502; },
      [&](double) { largest = std::max(largest, press.force(Edge::top)); });
  EXPECT_LE(largest, 0.);
  EXPECT_NEAR(press.force(Edge::top), 0., 1e-12 * stress);
}

TEST(Walls, GrippingOnesHoldSidewaysAndPull)
{
  const auto widest = [](const scene::WallGrip grip)
  {
    Press press(block(grip));
    press.close(0.5, 1.5);
    press.move(40., 40, squeeze(0.01));
    double widest = 0.; // displacement sideways of the points next to the wall
    for (std::size_t p = 0; p < press.solid.points.size(); ++p)
      if (const Point X = press.solid.fraction.initial(press.solid.points, p);
          X[1] > 1.5 - 0.5 * dx)
        widest = std::max(widest, std::abs(press.solid.points.x[p] - X[0]));
    return widest;
  };
  const double free = 0.5 * 0.33 / 0.67 * 0.01;
  EXPECT_NEAR(widest(scene::WallGrip::slip), free, 0.1 * free);
  EXPECT_LT(widest(scene::WallGrip::grip), 0.3 * free);

  Press pull(block(scene::WallGrip::grip));
  pull.close(0.5, 1.5);
  pull.move(40., 40, squeeze(-0.002));
  EXPECT_GT(pull.force(Edge::top), 0.8 * 0.002 * plane_strain_modulus(pull.solid));
}

// So do those that came up to the block: what touches a wall sticks to it.
TEST(Walls, GrippingOnesPullAtWhatTheyHaveCaught)
{
  for (const double bottom : {0.5, 0.47, 0.44})
  {
    Press press(block(scene::WallGrip::grip, {0.5, bottom}));
    press.close(bottom, bottom + 1.12);
    press.move(150., 300,
               [&](const Edge side, const double s)
               {
                 if (side == Edge::bottom)
                   return bottom;
                 return bottom + (s < 0.6 ? 1.12 - 0.13 * smooth(s / 0.6)
                                          : 0.99 + 0.06 * smooth((s - 0.6) / 0.4));
               });
    // Caught at 1, or up to a fraction of a cell earlier, then pulled to 1.05.
    const double pull = press.force(Edge::top) / plane_strain_modulus(press.solid);
    EXPECT_GT(pull, 0.035) << bottom;
    EXPECT_LT(pull, 0.055) << bottom;
  }
}

// A wall that comes from afar presses as if it had started where the block ends: the offset of the
// force in terms of travel stays below an eighth of a cell, and little work is lost in between.
TEST(Walls, ComingFromAfarPressAsFromContact)
{
  for (const double bottom : {0.5, 0.47, 0.44})
  {
    Press press(block(scene::WallGrip::slip, {0.5, bottom}));
    press.close(bottom, bottom + 1.12);
    constexpr double past = 0.04;
    press.move(100., 300,
               [&](const Edge side, const double s)
               { return side == Edge::top ? bottom + 1.12 - (0.12 + past) * s : bottom; });
    const double strain = -std::log(1. - past);
    const double width = std::exp(0.33 / 0.67 * strain);
    const double stiffness = plane_strain_modulus(press.solid) * width;
    EXPECT_NEAR(-press.force(Edge::top), stiffness * strain, 0.125 * dx * stiffness) << bottom;
    const History seen = history(press.solid);
    const auto value = [&](const std::string &name)
    {
      const auto &names = seen.names;
      return seen.row[std::find(names.begin(), names.end(), name) - names.begin()];
    };
    EXPECT_LT(value("transfer_loss"), 0.1 * value("elastic_energy")) << bottom;
    EXPECT_LT(std::abs(value("energy_balance")), 0.02 * value("elastic_energy")) << bottom;
  }
}

TEST(Walls, AQuarterGivesHalfTheForce)
{
  Press whole(block(scene::WallGrip::grip));
  whole.close(0.5, 1.5);
  whole.move(20., 20, squeeze(0.01));
  scene::Scene scene = block(scene::WallGrip::grip, {0., 0.});
  scene.domain.size = {1., 1.}, scene.domain.cells = {20, 20};
  scene.domain.boundary[static_cast<int>(Edge::left)] = scene::Boundary::symmetry;
  scene.domain.boundary[static_cast<int>(Edge::bottom)] = scene::Boundary::symmetry;
  scene.bodies = {grown::rectangle({0., 0.}, {0.5, 0.5})};
  scene.walls.erase(scene.walls.begin());
  Press quarter(scene);
  quarter.position = {{Edge::top, 0.5}};
  quarter.move(20., 20, [](Edge, const double s) { return 0.5 - 0.005 * smooth(s); });
  EXPECT_NEAR(quarter.force(Edge::top), 0.5 * whole.force(Edge::top),
              1e-3 * std::abs(whole.force(Edge::top)));
}

TEST(Walls, MeanVelocityOnTheNodesIsThatAtTheirPlaces)
{
  Press press(block(scene::WallGrip::slip));
  press.close(0.5, 1.5);
  press.move(40., 40, squeeze(0.01));
  // A homogeneous squeeze goes on: v_y = -rate (y - 1), also on the nodes next to the wall.
  const double rate = 0.001 * press.solid.material.wave_speed(), dt = 1e-4 / rate;
  const double top = 1.495, bottom = 0.505;
  for (std::size_t p = 0; p < press.solid.points.size(); ++p)
  {
    Points &points = press.solid.points;
    points.vx[p] = points.vy[p] = 0.;
    points.vy[p] = -rate * (points.y[p] - 1.), points.lyy[p] = -rate;
  }
  set_wall_motions(press.solid,
                   {{Edge::bottom, bottom + 0.495 * rate * dt, 0.495 * rate},
                    {Edge::top, top - 0.495 * rate * dt, -0.495 * rate}},
                   dt);
  NodalVelocity mean;
  advance(press.solid, dt, &mean);
  for (int j = 10; j <= 30; ++j)
  {
    const double expected = -rate * (j * dx - 1.);
    EXPECT_NEAR(mean.y[j * 41 + 20], expected, 0.02 * rate) << j;
  }
}
