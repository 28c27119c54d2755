// What a scene does not name costs nothing: no bytes, no calls, no columns, no step limit.
#include <algorithm>

#include <gtest/gtest.h>

#include "costs.h"
#include "forecast.h"
#include "forecast_growth.h"
#include "melt_history.h"
#include "record/reader.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  const std::string head = "title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [32, 32]\n"
                           "[[body]]\nshape = \"rectangle\"\ncorner = [4.0, 4.0]\n"
                           "size = [8.0, 8.0]\n[clock]\nend = 1.0\n";
  const std::string block = "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\ndensity = 1.0\n";
  const std::string growth = "[phase_field]\nwidth = 1.0\n[growth]\nanisotropy = 0.05\n"
                             "capillary_length = 0.185\n[heat]\ndiffusivity = 3.0\n"
                             "undercooling = 0.55\n";
  const std::string marker = "[phase_field]\nwidth = 1.0\n";

  /// A scene of that text, and its world after three steps.
  struct Moved
  {
    scene::Scene scene;
    World world;
    explicit Moved(const std::string &text) : scene(read(text)), world(build_world(scene, 1))
    {
      for (int k = 0; k < 3; ++k)
        step(world, std::min(coupling_step(world), 0.05));
    }
    static scene::Scene read(const std::string &text) { return scene_of(text); }

    /// Bytes of the parts whose names begin with `module`.
    double bytes(const std::string &module) const
    {
      double sum = 0.;
      for (const auto &[name, value] : memory(world))
        if (name.rfind(module, 0) == 0)
          sum += value;
      return sum;
    }
    long calls(const std::string &module) const
    {
      long sum = 0;
      for (const auto &part : parts(world))
        if (part.name.rfind(module, 0) == 0)
          sum += part.calls;
      return sum;
    }
    double number(const std::string &name) const
    {
      const auto all = numbers(world);
      const auto found = all.find(name);
      return found == all.end() ? 0. : found->second;
    }
    bool has_column(const std::string &name) const
    {
      const auto names = melt_history(world).names;
      return std::find(names.begin(), names.end(), name) != names.end();
    }
  };

  const std::string walled =
      "[[wall]]\nside = \"top\"\nspeed = 0.1\ntravel = 5.0\nstart_time = 0.0\n";
  const std::string pushed = "[imposed]\nvelocity = [\"0.1\", \"0\"]\n";
  const std::string noisy = "[noise]\nstrength = 1e-3\nseed = 1\n";

  /// Every column and table that a run of that scene writes, "|" after each.
  std::string output_of(const std::string &text)
  {
    const scene::Scene scene = Moved::read(text + "[[probe]]\nname = \"all\"\nhistory = true\n");
    const Scratch scratch;
    const std::string path = scratch / "absent.h5";
    World world = build_world(scene, 1);
    record::Writer writer(path, {}, scene, true);
    Recorder recorder(scene, writer);
    simulate(world, recorder, [](const World &now) { return now.steps < 2; });
    writer.finish({});
    const record::Reader reader(path);
    std::string all = "|";
    for (const auto &table : reader.tables())
    {
      all += table + '|';
      for (const auto &column : reader.table(table).columns.names)
        all += column + '|';
    }
    return all;
  }

  bool writes(const std::string &output, const std::string &name)
  {
    return output.find("|" + name + "|") != std::string::npos;
  }
} // namespace

TEST(Absent, MeltCostsASolidNothing)
{
  const Moved it(head + block);
  for (const char *module :
       {"phase field", "heat", "orientation", "growth", "velocity", "advection", "mean velocity",
        "extension", "noise", "walls", "imposed motion"})
    EXPECT_EQ(it.bytes(module), 0.) << module;
  for (const char *module : {"growth", "heat", "advection", "orientation", "extension", "distance",
                             "seeding", "walls", "imposed motion"})
    EXPECT_EQ(it.calls(module), 0) << module;
  EXPECT_TRUE(melt_history(it.world).names.empty());
  EXPECT_EQ(numbers(it.world).count("growth_step"), 0u);
  EXPECT_FALSE(it.world.mesh);
  // and what is there, is counted
  EXPECT_GT(it.bytes("solid points"), 0.);
  EXPECT_GT(it.calls("points to nodes"), 0);
}

TEST(Absent, WhatHoldsAndLoadsASolidCostsOneThatIsFreeNothing)
{
  const Moved free(head + block);
  const std::pair<std::string, std::string> asked[] = {
      {"supports", "[[support]]\non = \"bottom\"\ndisplacement = [\"0\", \"0\"]\n"},
      {"tractions", "[[traction]]\non = \"top\"\ntraction = [\"0\", \"0.01*t\"]\n"},
      {"body force", "[body_force]\nacceleration = [\"0\", \"-0.01\"]\n"}};
  for (const auto &[part, section] : asked)
  {
    EXPECT_EQ(free.bytes("solid " + part), 0.) << part;
    const Moved with(head + block + section);
    for (const auto &[other, its_section] : asked)
      EXPECT_EQ(with.bytes("solid " + other) > 0., other == part) << other << " beside " << part;
  }
  // A value for each point where it differs from one to another.
  const Moved uneven(head + block + "[body_force]\nacceleration = [\"0.01*X\", \"0\"]\n");
  EXPECT_GT(uneven.bytes("solid body force"), 16. * uneven.number("points"));
  EXPECT_GT(free.bytes("solid tracers"), 0.) << "the outline of a body is there";
}

TEST(Absent, SolidAndMotionCostACrystalNothing)
{
  const Moved it(head + growth);
  for (const char *module :
       {"solid", "velocity", "advection", "extension", "orientation", "noise", "walls", "imposed"})
    EXPECT_EQ(it.bytes(module), 0.) << module;
  EXPECT_EQ(it.number("noise_calls"), 0.);
  for (const char *module : {"points", "nodes", "sorting", "solid", "advection", "orientation",
                             "extension", "distance", "seeding", "walls", "imposed"})
    EXPECT_EQ(it.calls(module), 0) << module;
  // no gradients beside phi and theta where nothing moves: one field each
  const auto field = static_cast<double>(it.world.phase->value.bytes());
  EXPECT_EQ(it.bytes("phase field"), field);
  EXPECT_EQ(it.bytes("heat"), field);
  EXPECT_EQ(numbers(it.world).count("points"), 0u);
  EXPECT_GT(it.calls("growth"), 0);
  EXPECT_GT(it.bytes("growth"), 0.);
}

TEST(Absent, HeatCostsAMarkerNothing)
{
  const Moved it(head + marker + "[imposed]\nvelocity = [\"0.1\", \"0\"]\n");
  for (const char *module : {"heat", "growth", "solid", "orientation"})
    EXPECT_EQ(it.bytes(module), 0.) << module;
  for (const char *module :
       {"growth", "heat", "walls", "points", "mean velocity", "orientation", "seeding"})
    EXPECT_EQ(it.calls(module), 0) << module;
  EXPECT_EQ(it.bytes("mean velocity"), 0.) << "advection.interval is 1";
  EXPECT_FALSE(it.has_column("theta_mean"));
  EXPECT_FALSE(it.has_column("active_tiles"));
  EXPECT_FALSE(it.has_column("carried_phase"));
  EXPECT_TRUE(it.has_column("solid_area"));
  EXPECT_EQ(it.calls("advection"), 3);
  EXPECT_EQ(it.calls("imposed motion"), 3);
}

TEST(Absent, PhaseCostsHeatAloneNothing)
{
  const Moved it("title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [32, 32]\n[heat]\n"
                 "diffusivity = 1.0\nundercooling = 0.0\n[clock]\nend = 1.0\n");
  for (const char *module : {"phase field", "solid", "orientation", "velocity", "advection"})
    EXPECT_EQ(it.bytes(module), 0.) << module;
  EXPECT_EQ(it.calls("growth"), 0);
  EXPECT_EQ(it.calls("heat"), 3);
  EXPECT_FALSE(it.has_column("solid_area"));
  EXPECT_FALSE(it.has_column("carried_heat"));
}

TEST(Absent, WhatIsThereIsCounted)
{
  const Moved it(head + growth + noisy + block + walled);
  EXPECT_GT(it.bytes("noise"), 4. * 2. * 33.); // a width for each line of nodes
  EXPECT_GT(it.number("noise_calls"), 0.);
  EXPECT_GT(it.bytes("walls"), 0.);
  EXPECT_EQ(it.calls("walls"), 3);
  EXPECT_GT(Moved(head + marker + pushed).bytes("imposed motion"), 0.);
  const Moved third(head + marker + pushed + "[advection]\ninterval = 3\n");
  EXPECT_GT(third.bytes("mean velocity"), 2. * 8. * 33. * 33.);
  EXPECT_EQ(third.calls("mean velocity"), 3);
  EXPECT_EQ(third.calls("advection"), 1);
  const Moved coupled(head + growth + block);
  EXPECT_GT(coupled.bytes("extension"), 0.);
  EXPECT_EQ(coupled.calls("extension"), 3);
  EXPECT_EQ(coupled.calls("distance"), 3); // within it
  EXPECT_EQ(coupled.calls("seeding"), 6);  // before the solid moves and after the crystal has grown
  EXPECT_EQ(coupled.bytes("solid tracers"), 0.) << "its outline is the front";
  EXPECT_EQ(coupled.calls("orientation"), 0);
  const Moved turning(head + growth + block + "[orientation]\n");
  EXPECT_EQ(turning.calls("orientation"), 6); // carried, and inherited by new solid
  EXPECT_GT(turning.bytes("orientation"), 0.);
}

namespace
{
  const char *const of_phase[] = {"solid_area", "interface_length", "interface_width", "phi_min",
                                  "phi_max"};
  const char *const of_heat[] = {"theta_mean", "theta_variance", "theta_min", "theta_max",
                                 "heat_content"};
  const char *const of_walls[] = {"compression", "swept_heat", "wall_top_position"};
  const char *const of_solid[] = {"kinetic_energy", "elastic_energy", "plastic_dissipation",
                                  "external_work",  "transfer_loss",  "energy_balance",
                                  "momentum_x"};
  const char *const of_both[] = {"inertia_travel", "inertia_compression", "force_imbalance"};
  const char *const of_growing_solid[] = {"grown_area", "melted_area", "owed_area", "area_drift"};

  template <std::size_t n>
  void expect_columns(const std::string &output, const char *const (&names)[n], const bool there)
  {
    for (const char *name : names)
      EXPECT_EQ(writes(output, name), there) << name << " in " << output;
  }
} // namespace

TEST(Absent, NoModuleWritesAColumnOfAnother)
{
  const struct
  {
    std::string text;
    bool phase, heat, walls, solid, grows;
  } cases[] = {{head + block, false, false, false, true, false},
               {head + block + walled, false, false, true, true, false},
               {head + block + marker, true, false, false, true, false},
               {head + growth, true, true, false, false, false},
               {head + growth + noisy, true, true, false, false, false},
               {head + growth + block + walled, true, true, true, true, true},
               {head + marker + pushed + walled, true, false, true, false, false},
               {head + growth + block, true, true, false, true, true},
               {head + marker + pushed, true, false, false, false, false}};
  for (const auto &it : cases)
  {
    const std::string output = output_of(it.text);
    expect_columns(output, of_phase, it.phase);
    expect_columns(output, of_heat, it.heat);
    expect_columns(output, of_walls, it.walls);
    expect_columns(output, of_solid, it.solid);
    expect_columns(output, of_both, it.walls && it.solid);
    expect_columns(output, of_growing_solid, it.grows);
    EXPECT_EQ(writes(output, "active_tiles"), it.heat);
    EXPECT_EQ(writes(output, "swept_phase"), it.walls && it.phase);
    EXPECT_EQ(output.find("noise"), std::string::npos) << "noise has nothing of its own to show";
  }
}

TEST(Forecast, CountsTheBytesThatTheRunWillHold)
{
  for (const std::string &text :
       {head + block, head + growth, head + marker + "[imposed]\nvelocity = [\"0.1\", \"0\"]\n"})
  {
    const Moved it(text);
    double held = 0.;
    for (const auto &[name, bytes] : memory(it.world))
      held += bytes;
    EXPECT_NEAR(make_forecast(it.scene, 1).solver_bytes(), held, 0.1 * held) << text;
  }
}

TEST(Forecast, KnowsTheTipVelocitiesOfTheory)
{
  // Microscopic solvability at undercooling 0.55: V d0/D = 0.01703 at eps = 0.05, 0.00542 at 0.015.
  auto scene = Moved::read(head + growth);
  EXPECT_NEAR(tip_velocity(scene) * 0.185 / 3., 0.01703, 0.1 * 0.01703);
  scene.growth->anisotropy = 0.015;
  EXPECT_NEAR(tip_velocity(scene) * 0.185 / 3., 0.00542, 0.1 * 0.00542);
  // Ivantsov's parabola: Delta = 0.55 has Pe = 0.257.
  EXPECT_NEAR(peclet_number(0.55), 0.257, 0.002);
}
