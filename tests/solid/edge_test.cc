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
