// From files to scenes: what a scene says is what is read, and all that is wrong is said at once.
#include "scene_file.h"

#include "scene/geometry.h"
#include "scene/quantities.h"

using namespace scene_test;
using scene::read_scene;

TEST(ReadScene, FillsEveryFieldThatTheFileNames)
{
  const Folder folder;
  const scene::Scene s = read_scene(folder.write("bar.toml", bar));
  EXPECT_EQ(s.title, "bar");
  EXPECT_EQ(s.domain.cells, (std::array<int, 2>{50, 24}));
  EXPECT_DOUBLE_EQ(s.domain.spacing()[0], 0.1);
  EXPECT_EQ(std::get<scene::Rectangle>(s.bodies.at(0).shape).size, scene::Point(1., 2.));
  EXPECT_EQ(s.solid->density, 7800.);
  EXPECT_FALSE(s.solid->viscosity);
  ASSERT_EQ(s.supports.size(), 2u);
  EXPECT_EQ(s.supports[0].name, "top");
  EXPECT_EQ(s.supports[0].displacement[0]->text, "0.4*t");
  EXPECT_EQ(s.supports[0].displacement[1]->text, "0");
  EXPECT_FALSE(s.supports[1].displacement[1]);
  EXPECT_EQ(s.supports[1].place.line, 17);
  EXPECT_EQ(std::get<scene::LineProbe>(s.probes.at(0).kind).points, 101);
  EXPECT_EQ(std::get<scene::ReactionProbe>(s.probes.at(1).kind).support, "top");
  EXPECT_EQ(*s.mpm->mach, 2e-3);
}

TEST(ReadScene, LeavesAbsentSectionsEmpty)
{
  const Folder folder;
  const scene::Scene s = read_scene(folder.write("bar.toml", bar));
  EXPECT_FALSE(s.phase_field || s.growth || s.heat || s.orientation || s.noise || s.imposed ||
               s.advection || s.extension || s.fe || s.body_force);
  EXPECT_TRUE(s.walls.empty() && s.tractions.empty());
}

TEST(ReadScene, ReadsItsOwnTextBackToTheSameScene)
{
  const Folder folder;
  const scene::Scene first = read_scene(folder.write("bar.toml", bar));
  const scene::Scene second = read_scene(folder.write("again.toml", first.text));
  EXPECT_EQ(first.text, second.text);
  EXPECT_EQ(first.hash, second.hash);
}

TEST(ReadScene, KeepsEveryBitOfANumberInItsText)
{
  const Folder folder;
  const double third = 1. / 3., tiny = 4.9406564584124654e-324;
  const scene::Scene first = read_scene(folder.write(
      "a.toml", with(with(bar, "0.3", "0.33333333333333331"), "7800", "4.9406564584124654e-324")));
  const scene::Scene second = read_scene(folder.write("b.toml", first.text));
  EXPECT_EQ(second.solid->poisson_ratio, third);
  EXPECT_EQ(second.solid->density, tiny);
}

TEST(ReadScene, HashFollowsContentNotLayout)
{
  const Folder folder;
  const std::string a = read_scene(folder.write("a.toml", bar)).hash;
  EXPECT_EQ(a, read_scene(folder.write("b.toml", "# a comment\n\n" + bar)).hash);
  EXPECT_NE(a, read_scene(folder.write("c.toml", with(bar, "7800", "7801"))).hash);
}

TEST(ReadScene, CollectsAllErrorsInOnePass)
{
  const Folder folder;
  std::string text = with(bar, "density = 7800", "density = -1"); // range
  text = with(text, "poisson_ratio", "poison_ratio");             // unknown, and missing
  text = with(text, "cells = [50, 24]", "cells = [50, \"24\"]");  // kind
  text = with(text, "\"0.4*t\"", "\"0.4*s\"");                    // expression
  text = with(text, "reaction = \"top\"", "reaction = \"lid\"");  // rule
  text += "[phase_feild]\nwidth = 1\n";                           // section
  const std::string said = errors(folder.write("many.toml", text));
  EXPECT_EQ(count(said, "[error]"), 7) << said;
  EXPECT_NE(said.find("the scene has 7 errors"), std::string::npos);
  EXPECT_NE(said.find("did you mean \"poisson_ratio\"?"), std::string::npos);
  EXPECT_NE(said.find("did you mean \"phase_field\"?"), std::string::npos);
  EXPECT_NE(said.find("poison_ratio = 0.3\n"), std::string::npos) << "the line itself is shown";
  EXPECT_NE(said.find("~~~"), std::string::npos) << "and underlined";
  EXPECT_LT(said.find(":4: "), said.find(":11: ")) << "in order of lines";
}

TEST(ReadScene, TurnsSyntaxErrorsIntoBadScene)
{
  const Folder folder;
  const std::string path = folder.write("broken.toml", "[domain]\nsize = [1, \n");
  const std::string said = errors(path);
  EXPECT_EQ(count(said, "[error]"), 1) << said;
  EXPECT_NE(said.find("no valid TOML"), std::string::npos) << said;
  EXPECT_NE(said.find(path + ":"), std::string::npos) << said;
}

TEST(ReadScene, NamesTheFileThatIsNotThere)
{
  EXPECT_NE(errors("nowhere/absent.toml").find("nowhere/absent.toml"), std::string::npos);
}

TEST(ReadScene, RefusesNestingThatNoSceneHas)
{
  const Folder folder;
  const std::string said =
      errors(folder.write("deep.toml", "a = " + std::string(100000, '[') + "\n"));
  EXPECT_NE(said.find("deeper"), std::string::npos) << said;
}

// Dots and brackets in texts and comments nest nothing; those after a text do.
TEST(ReadScene, AcceptsDotsAndBracketsInTextsAndComments)
{
  const Folder folder;
  std::string sum = "0.0";
  for (int i = 0; i < 40; ++i)
    sum += " + 0.0*abs(0.5)";
  const std::string dots(40, '.');
  const std::string text = "# " + dots + std::string(40, '[') + "\ntitle = 'it\"s " + dots + "'\n" +
                           with(bar, "\"0.4*t\"", "\"0.4*t + " + sum + "\"");
  EXPECT_EQ(errors(folder.write("long.toml", text.substr(0, text.find("title = \"")) +
                                                 text.substr(text.find("[domain]")))),
            "");
  for (const std::string first : {"a = \"x\\\"\"", "a = 'x\\'", "a = \"\"\"x\"\"\"", "a = \"x"})
    EXPECT_NE(
        errors(folder.write("deep.toml", first + "\nb = " + std::string(1000, '['))).find("deeper"),
        std::string::npos)
        << first;
}

TEST(Include, MergesSectionsAndNamedEntries)
{
  const Folder folder;
  folder.write("base/scene.toml", bar);
  const std::string quick = folder.write("quick.toml", R"(include = "base/scene.toml"
title = "quick"
[domain]
cells = [25, 12]
[[support]]
on = "top"
displacement = ["0.1*t", 0]
[[probe]]
name = "all"
region = "all"
of = ["von_mises"]
)");
  const scene::Scene s = read_scene(quick);
  EXPECT_EQ(s.title, "quick");
  EXPECT_EQ(s.domain.cells[0], 25);
  EXPECT_EQ(s.domain.size[0], 5.);
  ASSERT_EQ(s.supports.size(), 2u);
  EXPECT_EQ(s.supports[0].displacement[0]->text, "0.1*t");
  EXPECT_EQ(s.supports[1].displacement[0]->text, "-0.4*t");
  EXPECT_EQ(s.probes.size(), 3u);
  EXPECT_EQ(s.text.find("include"), std::string::npos);
}

TEST(Include, KeepsThePlaceOfEachOrigin)
{
  const Folder folder;
  const std::string base = folder.write("scene.toml", with(bar, "density = 7800", "density = 0"));
  const std::string quick =
      folder.write("quick.toml", "include = \"scene.toml\"\n[clock]\nend = -1\n");
  const std::string said = errors(quick);
  EXPECT_NE(said.find(base + ":12: solid.density"), std::string::npos) << said;
  EXPECT_NE(said.find(quick + ":3: clock.end"), std::string::npos) << said;
}

TEST(Include, LetsTheLaterOfExcludingKeysWin)
{
  const Folder folder;
  folder.write("scene.toml", with(bar, "reaction = \"top\"", "reaction = \"top\"\nevery = 0.1"));
  const scene::Scene s = read_scene(folder.write(
      "quick.toml", "include = \"scene.toml\"\n[[probe]]\nname = \"force\"\ntimes = [0.5]\n"));
  EXPECT_FALSE(s.probes.at(1).every);
  EXPECT_EQ(s.probes.at(1).times, std::vector<double>{0.5});
}

TEST(Include, RefusesCirclesAndAbsentFiles)
{
  const Folder folder;
  folder.write("a.toml", "include = \"b.toml\"\n");
  const std::string b = folder.write("b.toml", "include = \"a.toml\"\n" + bar);
  EXPECT_NE(errors(b).find("includes itself"), std::string::npos);
  const std::string c = folder.write("c.toml", "\ninclude = \"absent.toml\"\n" + bar);
  EXPECT_NE(errors(c).find(c + ":2: "), std::string::npos) << errors(c);
}

TEST(Override, ReachesSectionsAndNamedEntries)
{
  const Folder folder;
  const std::string path = folder.write("bar.toml", bar);
  const scene::Scene s =
      read_scene(path, {"mpm.points_per_cell=[3,3]", "support.top.displacement=[\"t\",\"free\"]",
                        "mpm.transfer=flip", "body.1.size=[1.0,1.5]", "accuracy=draft",
                        "fe.cells=[8,16]", "probe.line.points=11"});
  EXPECT_EQ(s.mpm->points_per_cell[0], 3);
  EXPECT_EQ(s.mpm->transfer, scene::Transfer::flip);
  EXPECT_EQ(s.supports[0].displacement[0]->text, "t");
  EXPECT_EQ(s.supports[0].displacement[0]->place.file, "--set");
  EXPECT_EQ(std::get<scene::Rectangle>(s.bodies[0].shape).size[1], 1.5);
  EXPECT_EQ(s.accuracy, "draft");
  EXPECT_EQ(s.fe->cells[1], 16);
  EXPECT_EQ(std::get<scene::LineProbe>(s.probes[0].kind).points, 11);
  EXPECT_NE(s.text.find("points_per_cell = [3, 3]"), std::string::npos);
}

TEST(Override, OfNothingIsRefused)
{
  const Folder folder;
  const std::string path = folder.write("bar.toml", bar);
  EXPECT_NE(errors(path, {"support.tpo.displacement=[0,0]"}).find("did you mean \"top\"?"),
            std::string::npos);
  EXPECT_NE(errors(path, {"mpm.mahc=1e-3"}).find("did you mean \"mach\"?"), std::string::npos);
  EXPECT_NE(errors(path, {"mpm.mach"}).find("--set:1"), std::string::npos);
}

TEST(Body, ComesFromAnOutlineFileBesideItsScene)
{
  const Folder folder;
  folder.write("shapes/frame.csv",
               "# a frame\n0,0\n4,0\n4,2\n0,2\n0,0\n\n1,0.5\n3,0.5\n3,1.5\n1,1.5\n");
  const std::string text = "[domain]\norigin = [-1, -1]\nsize = [6, 4]\ncells = [12, 8]\n"
                           "[[body]]\nshape = \"outline\"\nfile = \"frame.csv\"\n[phase_field]\n"
                           "width = 0.1\n[clock]\nend = 1\n";
  const std::string path = folder.write("shapes/scene.toml", text);
  const scene::Scene s = read_scene(path);
  EXPECT_EQ(std::get<scene::Polygon>(s.bodies[0].shape).outlines.at(0).size(), 4u);
  EXPECT_DOUBLE_EQ(scene::signed_distance(s.bodies, {2., 1.}), -0.5); // in the hole
  const std::string hash = s.hash;
  folder.write("shapes/frame.csv", "0,0\n4,0\n4,1\n");
  EXPECT_NE(read_scene(path).hash, hash) << "the outline is part of what is asked";
  folder.write("shapes/frame.csv", "0,0\n4,zero\n");
  EXPECT_NE(errors(path).find("frame.csv:2"), std::string::npos) << errors(path);
}

TEST(Body, NeedsTheKeysOfItsShapeAndNoOthers)
{
  const Folder folder;
  const std::string missing = errors(folder.write("a.toml", with(bar, "size = [1.0, 2.0]\n", "")));
  EXPECT_EQ(count(missing, "[error]"), 1) << missing;
  EXPECT_NE(missing.find("rectangle needs \"size\""), std::string::npos) << missing;
  const std::string foreign = errors(
      folder.write("b.toml", with(bar, "size = [1.0, 2.0]", "size = [1.0, 2.0]\nradius = 1")));
  EXPECT_NE(foreign.find("\"radius\" belongs to disc"), std::string::npos) << foreign;
}

TEST(Probe, HasExactlyOneKind)
{
  const Folder folder;
  EXPECT_NE(
      errors(folder.write("a.toml", bar + "[[probe]]\nname = \"x\"\n")).find("nothing says which"),
      std::string::npos);
  EXPECT_NE(errors(folder.write("b.toml",
                                bar + "[[probe]]\nname = \"x\"\nhistory = true\nsnapshot = true\n"))
                .find("exclude each other"),
            std::string::npos);
}

TEST(Probe, AsksForAllThatTheModulesKnowIfItDoesNotSay)
{
  const Folder folder;
  const std::string probes = "[[probe]]\nname = \"p\"\nat = [1, 1]\n"
                             "[[probe]]\nname = \"r\"\nregion = \"all\"\n";
  const std::string solid = "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n";
  const auto probe = [&](const std::string &text, const std::string &name)
  {
    for (const auto &candidate : scene::read_scene(folder.write("scene.toml", text)).probes)
      if (candidate.name == name)
        return candidate.of;
    return std::vector<std::string>{};
  };
  const std::vector<std::string> melt{"phi", "theta"};
  EXPECT_EQ(probe(seed + probes.substr(0, probes.find("[[probe]]", 3)), "p"), melt);
  const auto both = probe(seed + solid + probes, "p");
  EXPECT_EQ(both.size(),
            scene::solid_quantities.size() - 2 + 2); // a growing crystal has no strains
  EXPECT_EQ(both.back(), "theta");
  EXPECT_EQ(probe(seed + solid + probes, "r").size(), scene::solid_quantities.size() - 2);
}

TEST(Wall, StartsByTimeOrByDistance)
{
  const Folder folder;
  const std::string text = seed + "[solid]\nyoung_modulus = 1e4\npoisson_ratio = 0.3\ndensity = 1\n"
                                  "[[wall]]\nside = \"top\"\nspeed = 1\ntravel = 5\n";
  EXPECT_EQ(*read_scene(folder.write("a.toml", text)).walls.at(0).start_distance, 8.);
  EXPECT_EQ(*read_scene(folder.write("c.toml", with(with(text, "width = 1.0", "width = 0.5"),
                                                    "[growth]\nanisotropy = 0.05\n[heat]\n"
                                                    "diffusivity = 3.0\nundercooling = 0.55\n",
                                                    "")))
                 .walls.at(0)
                 .start_distance,
            4.)
      << "eight widths, whatever the unit";
  const scene::Scene s = read_scene(folder.write("b.toml", text + "start_time = 2\n"));
  EXPECT_EQ(*s.walls.at(0).start_time, 2.);
  EXPECT_FALSE(s.walls.at(0).start_distance);
}
