// Tractions on edges that no cell follows, and on parts of edges.
#include <gtest/gtest.h>

#include <string>

#include "small_scenes.h"

namespace
{
  scene::Scene disc(const int per_cell)
  {
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, {2.4, 2.4}, {12, 12});
    scene.bodies[0].shape = scene::Disc{{1.2, 1.2}, 0.93};
    scene.mpm->points_per_cell = {per_cell, per_cell};
    return scene;
  }

  double largest(const solid::Solid &solid, const std::string &name)
  {
    double value = 0.;
    const record::Snapshot snapshot = solid::snapshot(solid, {name}); // outlives the loop
    for (const double v : snapshot.fields.at(name))
      value = std::max(value, std::abs(v));
    return value;
  }
} // namespace

// A uniform stress and the pressure that balances it: div(-p I) = 0, so nothing moves. Compared
// with p/K times the radius, which the disc would shrink by without its stress.
TEST(Traction, PressureOnACutEdgeIsBalancedByTheSameStress)
{
  for (const int per_cell : {2, 3})
  {
    scene::Scene scene = disc(per_cell);
    scene.bodies[0].initial_stress = {small::text("-1"), small::text("-1"), small::text("-1"),
                                      small::text("0")};
    scene::Traction load;
    load.name = "pressure", load.where = scene::Box{{0., 0.}, {2.4, 2.4}};
    load.traction = {small::text("0"), small::text("0")}, load.pressure = small::text("1");
    scene.tractions.push_back(load);
    const solid::Owner body = solid::make_solid(scene);
    solid::advance(*body, 0.2); // seven times across
    const double bulk = 1000. / (3. * 0.4), moved = 0.93 / bulk;
    EXPECT_LT(largest(*body, "displacement_x"), 0.02 * moved) << per_cell;
    EXPECT_LT(largest(*body, "displacement_y"), 0.02 * moved) << per_cell;
  }
}

// A load that ends inside a chord of the outline acts on exactly its length.
TEST(Traction, OnAPartOfAnEdgeHasTheForceOfItsLength)
{
  scene::Scene scene = small::rectangle({0.2, 0.2}, {1., 1.}, {1.4, 1.4}, {7, 7});
  scene::Traction load;
  load.name = "punch", load.where = scene::Segment{{0.437, 1.2}, {0.771, 1.2}};
  load.traction = {small::text("0"), small::text("-1")};
  scene.tractions.push_back(load);
  const solid::Owner body = solid::make_solid(scene);
  const double dt = 1e-3;
  solid::advance(*body, dt);
  const solid::History history = solid::history(*body);
  double momentum = 0.;
  for (std::size_t k = 0; k < history.row.size(); ++k)
    if (history.names[k] == "momentum_y")
      momentum = history.row[k];
  EXPECT_NEAR(momentum, -(0.771 - 0.437) * dt, 1e-5 * dt); // the ends are found to 1e-6 cells
}

// Which points the shares are measured with is found again after a restart: the same bits.
TEST(Traction, GoesOnToTheSameBitsAfterARestart)
{
  scene::Scene scene = disc(2);
  scene::Traction load;
  load.name = "pull", load.where = scene::Box{{1.8, 0.}, {2.4, 2.4}};
  load.traction = {small::text("20"), small::text("0")};
  scene.tractions.push_back(load);
  const solid::Owner whole = solid::make_solid(scene), second = solid::make_solid(scene);
  solid::advance(*whole, 0.02);
  solid::restore(*second, solid::checkpoint(*whole));
  solid::advance(*whole, 0.06);
  solid::advance(*second, 0.06);
  EXPECT_GT(largest(*whole, "displacement_x"), 0.05);
  EXPECT_EQ(solid::checkpoint(*whole), solid::checkpoint(*second));
}

// Far more than the corner bears: it flows away, and the loaded edge with it.
TEST(Edges, ThatPartFromTheirMaterialStopTheRun)
{
  scene::Scene scene = small::rectangle({2., 1.5}, {2., 1.}, {6., 5.}, {24, 20});
  scene.solid->yield_stress = 2.;
  small::hold(scene, "root", scene::Edge::left, "0", "0");
  scene::Traction load;
  load.name = "corner", load.where = scene::Box{{3.7, 2.}, {4.5, 3.2}};
  load.traction = {small::text("2*ramp(t, 5)"), small::text("3*ramp(t, 5)")};
  scene.tractions.push_back(load);
  const solid::Owner bar = solid::make_solid(scene);
  try
  {
    solid::advance(*bar, 8.);
    FAIL() << "it went on";
  }
  catch (const solid::NumericalError &trouble)
  {
    EXPECT_NE(std::string(trouble.what()).find("has parted from the material"), std::string::npos)
        << trouble.what();
  }
}

// Two edges that are stretched along themselves to 2.5 times their length, where x - u(x) leads
// away from where the material started: each node is held by the motion of its own material.
TEST(Edge, StretchedAlongItselfCarriesItsMaterial)
{
  scene::Scene scene = small::rectangle({1.5, 0.2}, {1., 0.5}, {4., 1.}, {40, 10});
  scene.solid->poisson_ratio = 0.;
  scene.mpm->points_per_cell = {4, 4};
  for (const scene::Edge side : {scene::Edge::bottom, scene::Edge::top})
    small::hold(scene, side == scene::Edge::top ? "top" : "bottom", side,
                "1.5*smooth(t, 4)*(X - 2)", "0");
  small::hold(scene, "left", scene::Edge::left, "-0.75*smooth(t, 4)", "0");
  small::hold(scene, "right", scene::Edge::right, "0.75*smooth(t, 4)", "0");
  const solid::Owner block = solid::make_solid(scene);
  solid::advance(*block, 4.5);
  const double exact = 1000. * std::log(2.5); // sigma_xx of Hooke's law for rates, nu = 0
  const record::Snapshot points = solid::snapshot(*block, {"stress_xx"});
  const auto &stress = points.fields.at("stress_xx");
  double sum = 0.;
  for (const double s : stress)
    sum += s;
  EXPECT_NEAR(sum / static_cast<double>(stress.size()), exact, 0.02 * exact);
  double lower = 1e9, upper = -1e9;
  for (const scene::Polyline &line : solid::material_outline(*block))
    for (const scene::Point &x : line)
      lower = std::min(lower, x[0]), upper = std::max(upper, x[0]);
  EXPECT_NEAR(lower, 0.75, 0.01);
  EXPECT_NEAR(upper, 3.25, 0.01);
}
