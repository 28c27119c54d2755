// Is a compression quasi-static? The verdict, and the columns of the record that it rests on.
#include "inertia.h"

#include <algorithm>

#include "record/reader.h"
#include "scene_of.h"
#include "simulate.h"

namespace
{
  using simulated::Folder;
  using simulated::scene_of;

  const std::string other_wall =
      "[[wall]]\nside = \"bottom\"\nspeed = 0.1\ntravel = 4.4\nstart_time = 0.0\n";

  /// An elastic block of 8 x 8 between walls that come from 4 away; without yield stress, one per
  /// cent of E = 100 is what it bears.
  std::string pressed(const std::string &speed, const std::string &density)
  {
    return "title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [16, 16]\n"
           "[[body]]\nshape = \"rectangle\"\ncorner = [4.0, 4.0]\nsize = [8.0, 8.0]\n"
           "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\ndensity = " +
           density +
           "\n[phase_field]\nwidth = 1.0\n"
           "[[wall]]\nside = \"top\"\nspeed = " +
           speed +
           "\ntravel = 4.4\nstart_time = 0.0\n"
           "[[probe]]\nname = \"h\"\nhistory = true\nevery = 0.2\n[clock]\nend = 50.0\n";
  }

  struct Pressed
  {
    Folder folder;
    scene::Scene scene;
    World world;
    record::Table history;
    explicit Pressed(const std::string &text)
        : scene(scene_of(folder, text)), world(build_world(scene, 1))
    {
      record::Writer writer(folder / "record.h5", {}, scene, true);
      Recorder recorder(scene, writer);
      simulate(world, recorder, [](const World &) { return true; });
      writer.finish({});
      history = record::Reader(folder / "record.h5").table("h");
    }
    bool has(const std::string &name) const
    {
      const auto &names = history.columns.names;
      return std::find(names.begin(), names.end(), name) != names.end();
    }
    /// The last row's.
    double column(const std::string &name) const
    {
      const auto &names = history.columns.names;
      const auto found = std::find(names.begin(), names.end(), name);
      EXPECT_NE(found, names.end()) << name;
      return history.rows.back().at(static_cast<std::size_t>(found - names.begin()));
    }
  };

  bool says(const std::string &message, const std::string &words)
  {
    return message.find(words) != std::string::npos;
  }
} // namespace

// arm rho V^2/sigma over the arm: 0.1 * 0.1^2/1 = 0.1 %; each wall goes on by 0.4, together a
// tenth.
TEST(Inertia, OfASlowCompressionIsSmallAndSaidToBe)
{
  const Pressed run(pressed("0.1", "0.1") + other_wall);
  EXPECT_NEAR(run.column("compression"), 0.1, 0.02);
  EXPECT_NEAR(run.column("inertia_compression"), 1e-3, 1e-9);
  EXPECT_NEAR(run.column("inertia_travel"), 4e-3, 0.05 * 4e-3); // half of what is between them
  EXPECT_FALSE(run.has("momentum_to_force")) << "walls are opposite";
  EXPECT_GE(run.column("force_imbalance"), 0.);
  EXPECT_LT(run.column("force_imbalance"), 0.01) << "the block is its own mirror image";
  const std::string verdict = verdict_on_inertia(run.world);
  EXPECT_TRUE(says(verdict, "inertia alone takes 0.1 % of compression to stop an arm")) << verdict;
  EXPECT_TRUE(says(verdict, "kinetic energy is ")) << verdict;
  EXPECT_TRUE(says(verdict, "; opposite wall forces differ by 0.")) << verdict;
  EXPECT_TRUE(says(verdict, ": quasi-static beyond 0.2 %")) << verdict;
}

// At five times the speed of the other wall and ten times the density the block is thrown against
// it: 1 * 0.5^2/1 = 25 %.
TEST(Inertia, OfAFastCompressionIsSaid)
{
  const Pressed run(pressed("0.5", "1.0") + other_wall);
  EXPECT_NEAR(run.column("inertia_compression"), 0.25, 1e-9);
  const std::string verdict = verdict_on_inertia(run.world);
  EXPECT_TRUE(says(verdict, "inertia alone takes 25 % of compression")) << verdict;
  EXPECT_TRUE(says(verdict, ": not quasi-static")) << verdict;
}

// Pushed from one side only, in free flight afterwards: all of the force is momentum.
TEST(Inertia, WithOneWallAndNothingOppositeIsFreeFlight)
{
  const Pressed run(pressed("0.5", "0.1"));
  EXPECT_EQ(run.column("force_imbalance"), 0.);
  EXPECT_NEAR(run.column("momentum_to_force"), 1., 1e-6);
  const std::string verdict = verdict_on_inertia(run.world);
  EXPECT_FALSE(says(verdict, "opposite wall forces")) << verdict;
  EXPECT_TRUE(says(verdict, "inertia alone takes 2.5 %")) << verdict;
  EXPECT_TRUE(says(verdict, "; momentum takes 100 % of the wall's force: not quasi")) << verdict;
}

// The upper half of the block of the first test: what the lower wall was is the symmetry side.
TEST(Inertia, OfAHalfIsTheMomentumThatItsForceChanges)
{
  const std::string whole = pressed("0.1", "0.1");
  const std::string half = "title = \"t\"\n[domain]\norigin = [0.0, 8.0]\nsize = [16.0, 8.0]\n"
                           "cells = [32, 16]\nboundary = \"symmetry\"\n" +
                           whole.substr(whole.find("[[body]]"));
  const Pressed run(half);
  EXPECT_LT(run.column("momentum_to_force"), 0.1);
  EXPECT_GT(run.column("momentum_to_force"), 0.);
  const std::string verdict = verdict_on_inertia(run.world);
  EXPECT_TRUE(says(verdict, "; momentum takes ")) << verdict;
  EXPECT_TRUE(says(verdict, ": quasi-static beyond ")) << verdict;
}

TEST(Inertia, SaysNothingBeforeAWallHasCompressed)
{
  const Folder folder;
  const auto scene = scene_of(folder, pressed("0.1", "0.1") + other_wall);
  const World world = build_world(scene, 1);
  EXPECT_EQ(verdict_on_inertia(world), "");
}
