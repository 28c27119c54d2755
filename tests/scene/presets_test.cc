// accuracy = "...": what a preset writes, and what it leaves alone.
#include "scene/presets.h"

#include "scene_file.h"

using namespace scene_test;
using scene::read_scene;

namespace
{
  const std::string bar_without_knobs =
      with(with(bar, "cells = [50, 24]\n", ""), "[mpm]\nmach = 2e-3\n", "");
  const std::string seed_without_cells = with(seed, "cells = [100, 100]\n", "");

  scene::Scene read(const std::string &text, const std::string &accuracy)
  {
    const Folder folder;
    return read_scene(folder.write("a.toml", "accuracy = \"" + accuracy + "\"\n" + text));
  }
} // namespace

TEST(Preset, ResolvesTheThinnestBodyFinerAndFiner)
{
  int last = 0;
  for (const char *accuracy : {"draft", "standard", "fine"})
  {
    const scene::Scene s = read(bar_without_knobs, accuracy);
    EXPECT_NEAR(s.domain.spacing()[0], s.domain.spacing()[1], 1e-12) << accuracy;
    EXPECT_GT(s.domain.cells[0], last) << accuracy;
    last = s.domain.cells[0];
    EXPECT_TRUE(s.mpm->mach) << "driven by supports alone: the density may be scaled";
    EXPECT_GT(s.fe->cells[0], 0);
  }
}

TEST(Preset, ResolvesTheInterfaceWhereACrystalGrows)
{
  EXPECT_LE(read(seed_without_cells, "draft").domain.spacing()[0], 0.8 + 1e-12);
  EXPECT_LE(read(seed_without_cells, "fine").domain.spacing()[0], 0.4 + 1e-12);
}

TEST(Preset, LeavesWrittenKeysAlone)
{
  const scene::Scene s = read(bar, "draft");
  EXPECT_EQ(s.domain.cells[0], 50);
  EXPECT_EQ(*s.mpm->mach, 2e-3);
  const std::string said = scene::describe_preset(s);
  EXPECT_NE(said.find("mpm.mach = 0.002 (the scene's own; the preset says"), std::string::npos)
      << said;
}

TEST(Preset, AddsNoModule)
{
  const scene::Scene s = read(seed_without_cells, "fine");
  EXPECT_FALSE(s.mpm);
  EXPECT_FALSE(s.fe);
  EXPECT_FALSE(s.advection);
}

TEST(Preset, NeverScalesTheDensityOfWhatIsThrown)
{
  const std::string thrown = with(bar_without_knobs, "size = [1.0, 2.0]\n",
                                  "size = [1.0, 2.0]\nvelocity = [\"1\", \"0\"]\n");
  EXPECT_FALSE(read(thrown, "draft").mpm->mach);
  EXPECT_TRUE(read(with(thrown, "\"1\", \"0\"", "\"0.0\", \"0\""), "draft").mpm->mach) << "at rest";
}

// The letter t is in sqrt, too.
TEST(Preset, KnowsWhatIsDrivenFromWhatStandsStill)
{
  const std::string still =
      with(with(bar_without_knobs, "\"0.4*t\"", "\"0*sqrt(X)\""), "\"-0.4*t\"", "\"0*t\"");
  const auto mpm = read(still, "draft").mpm;
  EXPECT_FALSE(mpm && mpm->mach);
}

TEST(Preset, BlamesAnInterfaceThatIsFarTooThin)
{
  const Folder folder;
  const std::string thin = with(seed_without_cells, "width = 1.0", "width = 1e-12");
  const std::string said = errors(folder.write("a.toml", "accuracy = \"draft\"\n" + thin));
  EXPECT_NE(said.find("a.toml:1"), std::string::npos) << said;
  EXPECT_NE(said.find("cells of 8e-13 are wanted"), std::string::npos) << said;
  EXPECT_NE(said.find("phase_field.width"), std::string::npos) << said;
}

// The support moves as before, but the run ends before a wave has crossed the bar: inertia is what
// is looked at.
TEST(Preset, NeverScalesTheDensityOfAWave)
{
  const std::string brief = with(bar_without_knobs, "[clock]\nend = 1.0", "[clock]\nend = 1e-4");
  EXPECT_TRUE(read(bar_without_knobs, "draft").mpm->mach);
  EXPECT_FALSE(read(brief, "draft").mpm->mach);
}

// The ends go 0.002 of the bar's two metres: ten crossings of a scaled wave meanwhile take a Mach
// number of 1e-4 (a yield strain of 0.002 would else be reached before a wave is across).
TEST(Preset, ScalesTheDensityLessForAShortWay)
{
  const std::string little = with(with(bar_without_knobs, "0.4*t", "0.002*sin(6.2832*t)"), "-0.4*t",
                                  "-0.002*sin(6.2832*t)");
  const auto mach = read(little, "draft").mpm->mach;
  ASSERT_TRUE(mach);
  EXPECT_NEAR(*mach, 1e-4, 1e-6);
  for (const auto &[accuracy, crossings] : {std::pair{"standard", 20.}, {"fine", 40.}})
    EXPECT_NEAR(*read(little, accuracy).mpm->mach, 1e-3 / crossings, 1e-6) << accuracy;
}

// What is held whole is not resolved: a grip of a tenth of the bar's width asks for no finer
// cell.
TEST(Preset, LeavesOutWhatASupportHoldsWhole)
{
  const std::string grip = "[[body]]\nname = \"grip\"\nshape = \"rectangle\"\n"
                           "corner = [3.0, 1.0]\nsize = [0.1, 0.4]\n";
  const std::string holding = "[[support]]\nname = \"held\"\n"
                              "region = { lower = [3.0, 1.0], upper = [3.1, 1.4] }\n"
                              "displacement = [\"0\", \"0\"]\n";
  const auto alone = read(bar_without_knobs, "draft").domain.cells;
  EXPECT_EQ(read(bar_without_knobs + grip + holding, "draft").domain.cells, alone);
  EXPECT_GT(read(bar_without_knobs + grip, "draft").domain.cells[0], alone[0]);
  const std::string half = with(holding, "\"0\", \"0\"", "\"0\", \"free\"");
  EXPECT_GT(read(bar_without_knobs + grip + half, "draft").domain.cells[0], alone[0]);
}

TEST(Preset, GivesMorePointsToWhatStaysElastic)
{
  const std::string elastic = with(bar_without_knobs, "yield_stress = 4e8\n", "");
  EXPECT_EQ(read(elastic, "fine").mpm->points_per_cell, (std::array<int, 2>{4, 4}));
  EXPECT_EQ(read(bar_without_knobs, "fine").mpm->points_per_cell, (std::array<int, 2>{2, 2}));
}

// Of the cells' 0.1 and D = 3: 0.1, 0.05 and 0.025 of dx^2/D.
TEST(Preset, ShortensTheStepWhereNoiseAloneMovesTheHeat)
{
  const std::string noisy =
      "title = \"a\"\n[domain]\nsize = [1.0, 1.0]\ncells = [10, 10]\n"
      "[heat]\ndiffusivity = 3.0\nundercooling = 0.0\n[noise]\nstrength = 1e-4\n"
      "[clock]\nend = 1.0\n";
  for (const auto &[accuracy, fraction] :
       {std::pair{"draft", 0.1}, {"standard", 0.05}, {"fine", 0.025}})
    EXPECT_NEAR(*read(noisy, accuracy).clock.step, fraction * 0.01 / 3., 1e-9) << accuracy;
  EXPECT_EQ(*read(with(noisy, "end = 1.0\n", "end = 1.0\nstep = 1e-4\n"), "fine").clock.step, 1e-4);
  EXPECT_FALSE(read(seed_without_cells, "fine").clock.step);
}

// 0.4 m/s at a wave speed of 73 m/s: a Mach number of 5e-3 would take density away.
TEST(Preset, NeverTakesDensityAway)
{
  const std::string light = with(bar_without_knobs, "density = 7800\n", "density = 5e7\n");
  EXPECT_FALSE(read(light, "draft").mpm->mach);
}

TEST(Preset, IsPartOfWhatIsAsked)
{
  EXPECT_NE(read(seed_without_cells, "draft").hash, read(seed_without_cells, "fine").hash);
  EXPECT_NE(read(seed_without_cells, "draft").text.find("precision"), std::string::npos);
}

TEST(Preset, SaysWhereNoMeshCanBeChosen)
{
  const Folder folder;
  const std::string odd = with(seed_without_cells, "size = [40.0, 40.0]", "size = [40.0, 39.97]");
  const std::string said = errors(folder.write("a.toml", "accuracy = \"draft\"\n" + odd));
  EXPECT_NE(said.find("give [domain] cells"), std::string::npos) << said;
}

TEST(Preset, WithoutAccuracyChangesNothing)
{
  const Folder folder;
  const scene::Scene s = read_scene(folder.write("a.toml", bar));
  EXPECT_EQ(scene::describe_preset(s), "");
  EXPECT_NE(errors(folder.write("b.toml", bar_without_knobs)).find("cells"), std::string::npos);
}

TEST(Override, TakesAKeyAway)
{
  const Folder folder;
  const std::string path = folder.write("bar.toml", bar);
  EXPECT_FALSE(read_scene(path, {"mpm.mach="}).mpm->mach);
  EXPECT_NE(errors(path, {"domain.cells="}).find("cells"), std::string::npos);
  EXPECT_NE(errors(path, {"mpm.mahc="}).find("no key mpm.mahc"), std::string::npos);
  EXPECT_GT(read_scene(path, {"domain.cells=", "accuracy=fine"}).domain.cells[0], 50);
}

TEST(SquareCells, DivideBothSides)
{
  EXPECT_EQ(scene::square_cells({5.0, 2.4}, 0.1), (std::array<int, 2>{50, 24}));
  EXPECT_EQ(scene::square_cells({6.0, 9.0}, 0.2), (std::array<int, 2>{30, 45}));
  EXPECT_EQ(scene::square_cells({1.0, 1.0001}, 0.1), (std::array<int, 2>{0, 0}));
}

// A footing that ends at 1.0 ends between nodes of 77 x 56 cells, on one of 88 x 64.
TEST(SquareCells, LieWhereASupportEnds)
{
  EXPECT_EQ(scene::square_cells({4.4, 3.2}, 0.0625), (std::array<int, 2>{77, 56}));
  EXPECT_EQ(scene::square_cells({4.4, 3.2}, 0.0625, {{{0.0, 1.0}, {}}}),
            (std::array<int, 2>{88, 64}));
  EXPECT_EQ(scene::square_cells({4.4, 3.2}, 0.0625, {{{0.987}, {}}}), (std::array<int, 2>{77, 56}))
      << "nowhere";
}
