// Advections and measurements of the distance that are not made at every coupling step: how often
// they are made, what the fields know in between, and that a run goes on from there.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "centre.h"
#include "costs.h"
#include "coupling.h"
#include "forecast.h"
#include "melt_history.h"
#include "pressed_seed.h"
#include "recorder.h"
#include "scene_of.h"
#include "solid/energy.h"
#include "solid/growing.h"

namespace
{
  using namespace simulated;

  /// A disc on a periodic square of 40 cells, carried along by (u, v).
  scene::Scene carried_disc(const std::string &u, const std::string &v, const double end)
  {
    scene::Scene scene;
    scene.domain.size = {1., 1.}, scene.domain.cells = {40, 40};
    scene.domain.boundary.fill(scene::Boundary::periodic);
    scene::Body disc;
    disc.name = "disc", disc.shape = scene::Disc{{0.4, 0.5}, 0.2};
    scene.bodies = {disc};
    scene.phase_field = scene::PhaseField{};
    scene.phase_field->width = 0.04;
    scene.imposed = scene::Imposed{};
    scene.imposed->velocity[0].text = u, scene.imposed->velocity[1].text = v;
    scene.advection = scene::Advection{};
    scene.clock.end = end;
    return scene;
  }

  long calls(const World &world, const std::string &part)
  {
    const auto all = parts(world);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.name == part; });
    return found == all.end() ? 0 : found->calls;
  }

  World gone(const scene::Scene &scene)
  {
    World world = build_world(scene, 1);
    while (world.time < scene.clock.end * (1. - 1e-12))
      step(world, std::min(coupling_step(world), scene.clock.end - world.time));
    return world;
  }

  double difference(const World &a, const World &b)
  {
    double most = 0.;
    for (int j = 0; j < a.mesh->nodes[1]; ++j)
      for (int i = 0; i < a.mesh->nodes[0]; ++i)
        most = std::max(most, std::abs(a.phase->value(i, j) - b.phase->value(i, j)));
    return most;
  }
} // namespace

TEST(AdvectionInterval, OfASteadyMotionIsALongerStep)
{
  scene::Scene scene = carried_disc("0.7", "-0.4 + 0.2*sin(2*pi*Y)", 0.4);
  scene.advection->step_fraction = 0.1, scene.advection->interval = 4;
  const double step_of_four = 4. * coupling_step(build_world(scene, 1));
  scene.clock.end = 24. * step_of_four;
  const World fourth = gone(scene);
  EXPECT_EQ(fourth.steps, 96);
  EXPECT_EQ(calls(fourth, "advection"), 24);
  EXPECT_EQ(fourth.uncarried->steps, 0);
  scene.advection->interval = 1;
  const World every = gone(scene);
  EXPECT_EQ(calls(every, "advection"), 96);
  EXPECT_FALSE(every.uncarried);
  scene.advection->step_fraction = 0.4;
  const World long_steps = gone(scene);
  EXPECT_EQ(long_steps.steps, 24);
  EXPECT_LT(difference(fourth, long_steps), 1e-11);
  EXPECT_GT(difference(fourth, every), 1e-6) << "they are not the same by chance";
}

// A motion that begins fast and comes to rest: what counts is its way, not its last velocity.
TEST(AdvectionInterval, FollowsTheWayOfAMotionThatChanges)
{
  scene::Scene scene = carried_disc("0.3*cos(pi*t/2)", "0", 1.);
  const double start = centre(build_world(scene, 1)), way = 0.3 * 2. / M_PI;
  scene.advection->interval = 6;
  World sixth = gone(scene);
  EXPECT_NEAR(static_cast<double>(calls(sixth, "advection")), sixth.steps / 6., 1.);
  catch_up(sixth);
  EXPECT_NEAR(centre(sixth) - start, way, 3e-3 * way); // by its last velocity 0.02 less
}

TEST(AdvectionInterval, IsCutShortBeforeTheSchemeBreaks)
{
  for (const auto &[scheme, together] :
       {std::pair{scene::AdvectionScheme::cip, 2}, {scene::AdvectionScheme::cip_hermite, 4}})
  {
    scene::Scene scene = carried_disc("1", "1", 0.2); // 0.2 cells a step: 40 of them
    scene.advection->scheme = scheme, scene.advection->interval = 1000;
    const World world = gone(scene);
    EXPECT_EQ(world.steps, 40);
    EXPECT_EQ(calls(world, "advection"), 40 / together);
  }
}

TEST(AdvectionInterval, EndsWhereAProbeLooks)
{
  scene::Scene scene = carried_disc("0.05", "0", 1.);
  scene.advection->interval = 7;
  scene.clock.step = 0.02;
  scene::Probe melt;
  melt.name = "melt", melt.kind = scene::HistoryProbe{}, melt.every = 0.2;
  scene.probes = {melt};
  const Scratch scratch;
  record::Writer writer(scratch / "run.h5", {}, scene, true);
  Recorder recorder(scene, writer);
  World world = build_world(scene, 1);
  long waited = 0;
  ASSERT_TRUE(simulate(world, recorder,
                       [&](const World &now)
                       {
                         waited += now.uncarried->steps > 0;
                         if (now.steps % 10 == 0)
                         {
                           EXPECT_EQ(now.uncarried->steps, 0) << now.time;
                         }
                         return true;
                       }));
  EXPECT_EQ(world.steps, 50);
  EXPECT_EQ(calls(world, "advection"), 10) << "the seventh step of ten, and the last";
  EXPECT_EQ(waited, 40);
}

TEST(AdvectionInterval, OfNothingThatMovesCarriesWhatIsLeft)
{
  scene::Scene scene = carried_disc("t < 0.102 ? 0.1 : 0", "0", 0.5);
  scene.advection->interval = 3;
  scene.clock.step = 0.01;
  const World world = gone(scene);
  EXPECT_EQ(world.uncarried->steps, 0);
  EXPECT_NEAR(centre(world) - centre(build_world(scene, 1)), 0.01, 0.0011); // a step at the end
}

// A bar that spins freely, with both intervals: phi turns with it.
TEST(Intervals, KeepTheMarkerOnABodyThatTurns)
{
  scene::Scene scene = carried_disc("0", "0", 1.2);
  scene.imposed.reset();
  scene.domain.size = {2., 2.};
  scene.domain.boundary.fill(scene::Boundary::no_flux);
  scene.bodies[0].shape = scene::Rectangle{{0.5, 0.85}, {1., 0.3}};
  scene.bodies[0].velocity[0].text = "-(Y - 1)", scene.bodies[0].velocity[1].text = "X - 1";
  scene.solid = scene::Solid{};
  scene.solid->young_modulus = 1e3, scene.solid->poisson_ratio = 0.3, scene.solid->density = 1.;
  scene.mpm = scene::Mpm{};
  scene.phase_field->width = 0.05;
  scene.advection->step_fraction = 0.05;
  const World every = gone(scene);
  scene.advection->interval = 4;
  scene.extension = scene::Extension{};
  scene.extension->interval = 5, scene.extension->map_interval = 40;
  World some = gone(scene);
  EXPECT_NEAR(static_cast<double>(calls(every, "advection")) / calls(some, "advection"), 4., 0.1);
  EXPECT_EQ(calls(every, "distance"), every.steps);
  EXPECT_NEAR(static_cast<double>(calls(every, "distance")) / calls(some, "distance"), 5., 0.3);
  catch_up(some);
  for (const World *world : {&every, static_cast<const World *>(&some)})
  {
    double xx = 0., yy = 0., xy = 0.; // of the solid part about the middle
    for (int j = 0; j < world->mesh->nodes[1]; ++j)
      for (int i = 0; i < world->mesh->nodes[0]; ++i)
      {
        const scene::Point r = world->mesh->position(i, j) - scene::Point(1., 1.);
        const double solid = 0.5 * (1. + world->phase->value(i, j));
        xx += solid * r[0] * r[0], yy += solid * r[1] * r[1], xy += solid * r[0] * r[1];
      }
    EXPECT_NEAR(0.5 * std::atan2(2. * xy, xx - yy), 1.2, 0.03);
  }
}

namespace
{
  /// Pressed in steps of a tenth of a cell at most.
  scene::Scene pressed_slowly()
  {
    scene::Scene scene = pressed_seed();
    scene.clock.step = 0.3;
    return scene;
  }

  scene::Scene pressed_with_intervals()
  {
    scene::Scene scene = pressed_slowly();
    scene.advection = scene::Advection{};
    scene.advection->interval = 3;
    scene.extension = scene::Extension{};
    scene.extension->interval = 4, scene.extension->map_interval = 10;
    return scene;
  }
} // namespace

TEST(Intervals, GoOnFromACheckpointToTheSameBits)
{
  const scene::Scene scene = pressed_with_intervals();
  World whole = build_world(scene, 1), resumed = build_world(scene, 1);
  while (solid::points(*whole.solid) == 0)
    go(whole, 1);
  for (int k = 0; k < 50 && (whole.uncarried->steps != 2 || !whole.extension->since_measured); ++k)
    go(whole, 1);
  ASSERT_EQ(whole.uncarried->steps, 2);
  ASSERT_GT(whole.extension->since_measured, 0) << "in the middle of both intervals";
  restore(resumed, state_of(whole));
  resumed.time = whole.time, resumed.steps = whole.steps;
  go(whole, 25), go(resumed, 25);
  EXPECT_EQ(whole.time, resumed.time);
  EXPECT_EQ(solid::checkpoint(*whole.solid), solid::checkpoint(*resumed.solid));
  for (int j = 0; j < whole.mesh->nodes[1]; ++j)
    for (int i = 0; i < whole.mesh->nodes[0]; ++i)
    {
      ASSERT_EQ(whole.phase->value(i, j), resumed.phase->value(i, j)) << i << ' ' << j;
      ASSERT_EQ(whole.heat->value(i, j), resumed.heat->value(i, j)) << i << ' ' << j;
      ASSERT_EQ(whole.orientation->angle(i, j), resumed.orientation->angle(i, j)) << i << ' ' << j;
    }
}

TEST(Intervals, KeepHeatWhileTheCrystalIsPressed)
{
  const scene::Scene scene = pressed_with_intervals();
  World world = build_world(scene, 1);
  const auto kept = [&]
  {
    const HistoryColumns row = melt_history(world);
    const auto value = [&](const std::string &name) {
      return row.values.at(std::find(row.names.begin(), row.names.end(), name) - row.names.begin());
    };
    return value("heat_content") + world.walls->swept_heat - 0.5 * world.walls->swept_phase -
           (value("carried_heat") - 0.5 * value("carried_phase"));
  };
  const double start = kept();
  while (medium::compression(*world.walls) < 0.05)
    go(world, 1);
  EXPECT_NEAR(kept(), start, 1e-10 * std::abs(start));
  EXPECT_LT(2 * calls(world, "advection"), calls(world, "mean velocity"));
  EXPECT_LT(2 * calls(world, "distance"), calls(world, "extension"));
  EXPECT_GT(memory(world).at("mean velocity"), 0.);
}

// With heat and points as without intervals, but for what lags by less than half a cell.
TEST(Intervals, PressTheCrystalAsEveryStepDoes)
{
  double area[2], drift[2];
  for (const int n : {0, 1})
  {
    const scene::Scene scene = n == 0 ? pressed_slowly() : pressed_with_intervals();
    World world = build_world(scene, 1);
    while (medium::compression(*world.walls) < 0.05)
      go(world, 1);
    catch_up(world);
    area[n] = solid::area_budget(*world.solid).phi;
    drift[n] = (area[n] - solid::area(*world.solid)) / area[n];
  }
  EXPECT_NEAR(area[1], area[0], 0.01 * area[0]);
  EXPECT_NEAR(drift[1], drift[0], 0.01);
}

TEST(Intervals, AreForecast)
{
  scene::Scene scene = carried_disc("0.1", "0", 10.);
  scene.advection->interval = 5;
  scene.clock.step = 0.01;
  const Forecast forecast = make_forecast(scene, 1);
  EXPECT_NEAR(forecast.counts.at("coupling steps"), 1000., 1.);
  EXPECT_NEAR(forecast.counts.at("advections"), 200., 1.);
  const World world = gone(scene);
  double held = 0.;
  for (const auto &[name, bytes] : memory(world))
    held += bytes;
  EXPECT_NEAR(forecast.solver_bytes(), held, 0.01 * held);
  scene.advection->interval = 1;
  EXPECT_EQ(make_forecast(scene, 1).counts.count("advections"), 0u);
}
