// The coupled program as a whole: a seed that grows up to a wall and is pressed by it.
#include <algorithm>

#include <gtest/gtest.h>

#include "../scratch.h"
#include "costs.h"
#include "coupling.h"
#include "forecast.h"
#include "inertia.h"
#include "medium/numerical_error.h"
#include "melt_history.h"
#include "pressed_seed.h"
#include "record/checkpoint.h"
#include "record/reader.h"
#include "scene/geometry.h"
#include "scene/reader.h"
#include "scene/value.h"
#include "simulate.h"
#include "solid/growing.h"

using namespace simulated;

TEST(Coupled, TroubleOfTheMeltTellsItsTime)
{
  scene::Scene scene = pressed_seed();
  scene.growth->step = 2.5 * build_world(scene, 1).growth->step_limit();
  World world = build_world(scene, 1, true);
  try
  {
    go(world, 1000);
    FAIL() << "it went on";
  }
  catch (const medium::NumericalError &trouble)
  {
    const std::string said = trouble.what();
    EXPECT_EQ(said.rfind("from time " + scene::number_text(world.time) + " on, growth step", 0), 0u)
        << said;
  }
}

TEST(Coupled, TheReactionOfAWallTellsHowFarItWentBeforeItTouches)
{
  scene::Scene scene = pressed_seed();
  scene::Probe push;
  push.name = "push", push.kind = scene::ReactionProbe{"wall top"}, push.every = 0.5;
  scene.probes = {push};
  scene.clock.end = 2.;
  const Scratch scratch;
  const std::string path = scratch / "wall.h5";
  {
    World world = build_world(scene, 1);
    record::Writer writer(path, {}, scene, true);
    Recorder recorder(scene, writer);
    ASSERT_TRUE(simulate(world, recorder, [](const World &) { return true; }));
    EXPECT_FALSE(world.walls->walls[0].touched);
    writer.finish({});
  }
  const auto table = record::Reader(path).table("push");
  const auto column = static_cast<std::size_t>(
      std::find(table.columns.names.begin(), table.columns.names.end(), "displacement_y") -
      table.columns.names.begin());
  ASSERT_EQ(table.time.size(), 5u);
  for (std::size_t k = 0; k < table.time.size(); ++k)
    EXPECT_NEAR(table.rows[k][column], -0.2 * table.time[k], 1e-12);
}

TEST(Forecast, IsMadeOfAStepThatIsForced)
{
  scene::Scene scene = pressed_seed();
  scene.walls.clear(), scene.solid.reset(), scene.mpm.reset();
  scene.clock.end = 1.;
  scene.growth->step = (1. + 1e-6) * build_world(scene, 1).growth->step_limit();
  EXPECT_THROW(make_forecast(scene, 1), scene::BadScene);
  EXPECT_GT(make_forecast(scene, 1, true).cpu_s(), 0.);
}

TEST(Coupled, NoPointExistsBeforeAWallTouches)
{
  const scene::Scene scene = pressed_seed();
  World world = build_world(scene, 1);
  while (!world.walls->walls[0].touched)
  {
    ASSERT_EQ(solid::points(*world.solid), 0);
    ASSERT_EQ(memory(world).at("solid points"), 0.);
    ASSERT_EQ(memory(world).at("advection"), 0.) << "nothing is carried before anything moves";
    ASSERT_FALSE(world.melt_moves);
    go(world, 1);
  }
  go(world, 2);
  EXPECT_GT(solid::points(*world.solid), 100);
  EXPECT_TRUE(world.melt_moves);
}

TEST(Coupled, GoesOnFromACheckpointToTheSameBits)
{
  const scene::Scene scene = pressed_seed();
  for (const bool touched : {false, true})
  {
    World whole = build_world(scene, 1), resumed = build_world(scene, 1);
    go(whole, 4);
    while (touched && solid::points(*whole.solid) == 0)
      go(whole, 1);
    go(whole, 3);
    ASSERT_EQ(touched, whole.walls->walls[0].touched.has_value());
    restore(resumed, state_of(whole));
    resumed.time = whole.time, resumed.steps = whole.steps;
    go(whole, 25), go(resumed, 25);
    ASSERT_EQ(whole.time, resumed.time);
    EXPECT_EQ(whole.heat->advected, resumed.heat->advected);
    EXPECT_EQ(whole.phase->advected, resumed.phase->advected);
    EXPECT_NE(whole.heat->advected, 0.);
    EXPECT_EQ(medium::pack(*whole.walls), medium::pack(*resumed.walls));
    EXPECT_EQ(solid::checkpoint(*whole.solid), solid::checkpoint(*resumed.solid));
    for (int j = 0; j < whole.mesh->nodes[1]; ++j)
      for (int i = 0; i < whole.mesh->nodes[0]; ++i)
      {
        ASSERT_EQ(whole.phase->value(i, j), resumed.phase->value(i, j)) << i << ' ' << j;
        ASSERT_EQ(whole.heat->value(i, j), resumed.heat->value(i, j)) << i << ' ' << j;
      }
  }
}

TEST(Coupled, WithoutWallsTheCrystalHasItsPointsAtOnceAndStaysFreeOfStress)
{
  scene::Scene scene = pressed_seed();
  scene.walls.clear();
  scene.mpm->mach.reset();
  scene.solid->density = 1e4;
  World world = build_world(scene, 1);
  go(world, 20);
  const solid::AreaBudget budget = solid::area_budget(*world.solid);
  EXPECT_GT(budget.grown, 1.);
  EXPECT_NEAR(budget.imbalance(), 0., 1e-10 * budget.phi);
  const auto snapshot = solid::snapshot(*world.solid, {"von_mises", "pressure"});
  for (const char *field : {"von_mises", "pressure"})
    for (const double stress : snapshot.fields.at(field))
      ASSERT_NEAR(stress, 0., 1e-9) << field;
}

// A spin of the body turns the crystal's axes by half the curl, carries phi and stresses nothing.
TEST(Coupled, ACrystalWithoutWallsStartsWithItsBodysVelocity)
{
  scene::Scene scene = pressed_seed();
  scene.walls.clear();
  scene.mpm->mach.reset();
  scene.solid->density = 0.1, scene.solid->yield_stress.reset();
  scene.domain.lower = {-16., -16.}, scene.domain.size = {32., 32.};
  scene.domain.cells = {40, 40};
  scene.domain.boundary.fill(scene::Boundary::no_flux);
  scene.heat->undercooling = 0.; // hardly anything grows
  scene.bodies[0].velocity = {scene::Expression{"0.1-0.02*Y", {}}, scene::Expression{"0.02*X", {}}};
  scene.clock.end = 10.;
  World world = build_world(scene, 1);
  activate_solid(world);
  const double mass =
      solid::density_scaling(*world.solid).density * solid::area_budget(*world.solid).phi;
  EXPECT_NEAR(mass, 0.1 * 3.1416 * 64., 0.01 * mass);
  go(world, 100000);
  const auto row = solid::history(*world.solid);
  const auto value = [&](const std::string &name)
  { return row.row[std::find(row.names.begin(), row.names.end(), name) - row.names.begin()]; };
  EXPECT_NEAR(value("momentum_x"), 0.1 * value("mass"), 1e-3 * value("mass"));
  EXPECT_NEAR(value("momentum_y"), 0., 1e-3 * value("mass"));
  EXPECT_NEAR(value("transfer_loss"), 0., 0.01 * value("kinetic_energy"));
  EXPECT_NEAR(value("energy_balance"), 0., 0.001 * value("kinetic_energy"));
  double x = 0., area = 0.;
  for (int j = 0; j < world.mesh->nodes[1]; ++j)
    for (int i = 0; i < world.mesh->nodes[0]; ++i)
      if (world.phase->value(i, j) > 0.)
        area += 1., x += world.mesh->position(i, j)[0];
  EXPECT_NEAR(x / area, 0.1 * world.time, 0.1);
  // Inside, at the front and in the melt, whose growth reads the angle: half the curl over the
  // front would leave the outermost nodes up to a tenth behind.
  const double turned = 0.02 * world.time;
  for (int j = 0; j < world.mesh->nodes[1]; ++j)
    for (int i = 0; i < world.mesh->nodes[0]; ++i)
      if (world.phase->value(i, j) > -0.99)
      {
        ASSERT_NEAR(world.orientation->angle(i, j), turned, 0.005 * turned) << i << ' ' << j;
      }
}

// What the walls sweep and what advection, which is no flux, adds to the integrals is booked; what
// is left is constant. Of the walls' work the transfers take some per cent; but for what relaxed
// pressures take, one per cent here, the rest is found again.
TEST(Coupled, HeatAndEnergyAreKeptWhileTheCrystalIsPressed)
{
  const scene::Scene scene = pressed_seed();
  World world = build_world(scene, 1);
  const auto kept = [&](const bool booked)
  {
    const HistoryColumns row = melt_history(world);
    const auto value = [&](const std::string &name) {
      return row.values.at(std::find(row.names.begin(), row.names.end(), name) - row.names.begin());
    };
    return value("heat_content") + world.walls->swept_heat - 0.5 * world.walls->swept_phase -
           (booked ? value("carried_heat") - 0.5 * value("carried_phase") : 0.);
  };
  const double start = kept(true);
  while (medium::compression(*world.walls) < 0.05)
    go(world, 1);
  EXPECT_GT(std::abs(kept(false) - start), 1e-3 * std::abs(start));
  EXPECT_NEAR(kept(true), start, 1e-10 * std::abs(start));
  const solid::LostEnergy lost = solid::lost_energy(*world.solid);
  EXPECT_GT(lost.transfer, 0.02);
  EXPECT_LT(std::abs(lost.unaccounted), 0.03);
}

TEST(Coupled, AWallThatNeverStartedIsSaid)
{
  scene::Scene scene = pressed_seed();
  World world = build_world(scene, 1);
  go(world, 1);
  EXPECT_EQ(warning_on_idle_walls(world), "");
  scene.walls[0].start_time.reset();
  scene.walls[0].start_distance = 1.;
  World far = build_world(scene, 1);
  go(far, 1);
  EXPECT_NE(warning_on_idle_walls(far).find("wall top never started"), std::string::npos);
}

TEST(Coupled, AWallThatMetNothingIsSaid)
{
  const scene::Scene scene = pressed_seed();
  World world = build_world(scene, 1);
  EXPECT_EQ(warning_on_missing_walls(world), "") << "it has not moved";
  go(world, 1);
  EXPECT_NE(warning_on_missing_walls(world).find("and met nothing"), std::string::npos);
  world.walls->walls[0].touched = world.time;
  EXPECT_EQ(warning_on_missing_walls(world), "");
}

TEST(Coupled, InertiaIsThatOfTheFastestWall)
{
  scene::Scene scene = pressed_seed();
  scene.domain.lower = {0., -16.}, scene.domain.size = {20., 32.}, scene.domain.cells = {25, 40};
  scene::Wall still;
  still.side = scene::Edge::bottom;
  scene.walls.push_back(still);
  const World world = build_world(scene, 1);
  std::swap(scene.walls[0], scene.walls[1]);
  const World swapped = build_world(scene, 1);
  EXPECT_GT(inertia(world).compression(), 0.);
  EXPECT_EQ(inertia(world).compression(), inertia(swapped).compression());
  EXPECT_TRUE(inertia(swapped).opposed);
  EXPECT_EQ(inertia(swapped).arm, 16.);

  scene.walls = {scene.walls[1], still}; // beside it, not opposite
  scene.walls[1].side = scene::Edge::left;
  const World beside = build_world(scene, 1);
  EXPECT_FALSE(inertia(beside).opposed);
  EXPECT_EQ(inertia(beside).arm, 32.) << "a mirror lies opposite the wall";
}
