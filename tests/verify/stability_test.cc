// Maps of stability on the fake solver.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  // What cells are judged by: the head of every stability.toml here.
  const std::string judged = R"toml(
[energy]
table = "energy"
of = "kinetic_energy"
[[accurate]]
take = {number = "largest"}
against = {number = 1}
norm = "absolute"
limit = 0.1
)toml";

  const std::string extremes = judged + R"toml(
[[map]]
name = "growth and error"
x = {key = "fake.growth", values = [0.0, 8.0]}
y = {key = "fake.error", values = [0.0, 0.5]}
bisections = 6
theory = "2*log(10)"
edge = [0.95, 1.05]
[[map]]
name = "exits"
x = {key = "fake.exit", values = [2, 3]}
[[map]]
name = "lists"
x = {key = "fake.growth", values = [0.0, 8.0]}
y = {label = "two at a time", set = ["fake.error={0}", "fake.h={1}"], values = [[0.0, 0.25]]}
theory = "4*log(10)*(y0 + 2*y1)"
)toml";

  /// Exit code of the maps of the case, whose file is `text`.
  int mapped(const Workspace &w, const std::string &text)
  {
    w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
    w.write("cases/bar/stability.toml", text);
    CampaignOptions options = w.options();
    options.cases = {"bar"};
    return stability(w.paths(), options);
  }
  nlohmann::json maps_of(const Workspace &w)
  {
    return nlohmann::json::parse(w.read("results/stability/bar.json"))["maps"];
  }
} // namespace

TEST(Stability, TellsTheClassesApartAndFindsTheEdge)
{
  const Workspace w;
  ASSERT_EQ(mapped(w, extremes), 0);
  const auto maps = maps_of(w);
  const auto &cells = maps[0]["cells"];
  EXPECT_EQ(cells[0]["class"], "accurate");
  EXPECT_EQ(cells[1]["class"], "growing energy");
  EXPECT_EQ(cells[2]["class"], "bounded but wrong");
  EXPECT_EQ(maps[1]["cells"][0]["class"], "refused");
  EXPECT_EQ(maps[1]["cells"][1]["class"], "diverged");
  EXPECT_NE(cells[0]["repeat"].get<std::string>().find("fake.growth=0"), std::string::npos);
  // exp(g)/exp(g/2) = 10 at g = 2 log 10 = 4.605
  const auto &edge = maps[0]["edges"][0];
  EXPECT_LE(edge["stable"].get<double>(), 4.61);
  EXPECT_GE(edge["unstable"].get<double>(), 4.60);
  EXPECT_LT(edge["unstable"].get<double>() - edge["stable"].get<double>(), 0.2);
  EXPECT_NEAR(edge["theory"].get<double>(), 4.605, 1e-3);
  EXPECT_NEAR(edge["ratio"].get<double>(), 1., 0.02);
  // two rows of six: the cells that the edges were found by are commands, too
  ASSERT_EQ(maps[0]["bisected"].size(), 12u);
  const std::string repeat = maps[0]["bisected"][0]["repeat"];
  EXPECT_NE(repeat.find("fake.growth=4.0"), std::string::npos) << repeat;
  EXPECT_EQ(maps[0]["bisected"][0]["class"], "accurate");
  // a theory knows the entries of a list
  EXPECT_NEAR(maps[2]["edges"][0]["theory"].get<double>(), 4.605, 1e-3);
}

TEST(Stability, TakesRunsOutOfTimeAndRefusedOnesForNeitherStableNorUnstable)
{
  const Workspace w;
  ASSERT_EQ(mapped(w, judged + R"toml(
[[map]]
name = "slow"
x = {key = "fake.sleep", values = [0.0, 30.0]}
time_limit_s = 0.3
bisections = 2
[[map]]
name = "refused between"
set = ["fake.hole=4"]
x = {key = "fake.growth", values = [0.0, 8.0]}
bisections = 4
)toml"),
            0);
  const auto maps = maps_of(w);
  EXPECT_EQ(maps[0]["cells"][1]["class"], "out of time");
  EXPECT_TRUE(maps[0]["edges"].empty()) << maps[0]["edges"];
  const auto &edge = maps[1]["edges"].at(0);
  EXPECT_EQ(edge["stopped"], "refused");
  EXPECT_EQ(edge["stable"], 0.);
  EXPECT_EQ(edge["unstable"], 8.);
}

TEST(Stability, FailsWhereAMapSaysNothing)
{
  const Workspace w;
  EXPECT_EQ(mapped(w, "[[map]]\nname = \"m\"\nset = [\"fake.exit=2\"]\n"
                      "x = {key = \"fake.h\", values = [1, 2]}\n"),
            1);
}

// The edge lies at 2 log 10 = 4.605 (above).
TEST(Stability, JudgesTheEdgeByTheTheoreticalLimit)
{
  const auto code = [](const std::string &x, const std::string &theory, const std::string &rest)
  {
    const Workspace w;
    const int found =
        mapped(w, judged + "[[map]]\nname = \"m\"\nx = {key = \"fake.growth\", values = " + x +
                      "}\nbisections = 6\ntheory = " + theory + "\n" + rest);
    EXPECT_EQ(found != 0, !maps_of(w)[0]["broken"].empty());
    return found;
  };
  const std::string x = "[0.0, 8.0]", bounds = "edge = [0.9, 1.1]\n";
  EXPECT_EQ(code(x, "4.605", bounds), 0);
  EXPECT_EQ(code(x, "4.0", bounds), 1);
  EXPECT_EQ(code(x, "5.3", bounds), 1);
  EXPECT_EQ(code(x, "4.0", ""), 0) << "only told";
  // no edge: stable beyond the limit, or unstable before it
  EXPECT_EQ(code("[0.0, 4.0]", "2.0", bounds), 1);
  EXPECT_EQ(code("[6.0, 8.0]", "10.0", bounds), 1);
  EXPECT_EQ(code("[0.0, 4.0]", "4.605", bounds), 0);
  // a limit of some rows only
  const std::string words = "y = {key = \"fake.word\", values = [\"a\", \"b\"]}\n" + bounds;
  EXPECT_EQ(code(x, "{a = 4.605, b = 4.605}", words), 0);
  EXPECT_EQ(code(x, "{a = 4.605, b = 3.0}", words), 1);
  EXPECT_EQ(code(x, "{a = 4.605}", words), 0);
}

TEST(Stability, WantsATheoryForTheBoundsOfAnEdge)
{
  const Workspace w;
  const std::string map = "[[map]]\nname = \"m\"\nx = {key = \"fake.h\", values = [1]}\n";
  EXPECT_THROW(mapped(w, map + "edge = [0.9, 1.1]\n"), BadInput);
  EXPECT_THROW(mapped(w, map + "theory = 1.0\nedge = 0.9\n"), BadInput);
}

// Nothing to compare with is no pass, and a fault that was found outlives what cannot be judged.
TEST(Stability, CallsNothingAccurateThatLacksItsReference)
{
  const auto kind = [](const std::string &error, const std::string &more)
  {
    const Workspace w;
    mapped(w, judged + "[[map]]\nname = \"m\"\nx = {key = \"fake.error\", values = [" + error +
                  "]}\n[[accurate]]\nnorm = \"absolute\"\nlimit = 0.1\n" + more);
    return maps_of(w)[0]["cells"][0]["class"].get<std::string>();
  };
  const std::string table = "take = {number = \"largest\"}\n"
                            "against = {csv = \"gone.csv\", of = \"a\", at = 0}\n",
                    column = "take = {number = \"gone\"}\nagainst = {number = 1}\n";
  EXPECT_EQ(kind("0.0", table), "not judged");
  EXPECT_EQ(kind("0.0", column), "not judged");
  EXPECT_EQ(kind("0.5", table), "bounded but wrong");
  EXPECT_EQ(kind("0.5", column), "bounded but wrong");
}

TEST(Stability, TakesAKeyAwayWhereAValueIsAbsent)
{
  const Workspace w;
  ASSERT_EQ(mapped(w, judged + R"toml(
[[map]]
name = "with and without"
x = {key = "fake.error", values = ["absent", 0.5], absent = 0}
[[accurate]]
name = "as large as the error"
take = {value = "largest - 1", with = {largest = {number = "largest"}}}
against = {number = "axis_x"}
norm = "absolute"
limit = 1e-9
)toml"),
            0);
  const auto cells = maps_of(w)[0]["cells"];
  EXPECT_EQ(cells[0]["x"], "absent");
  EXPECT_NE(cells[0]["repeat"].get<std::string>().find("fake.error= "), std::string::npos)
      << cells[0]["repeat"];
  EXPECT_EQ(cells[0]["class"], "accurate") << cells[0]["why"];
}

// The fake solver answers 1 + error h^2.
TEST(Stability, JudgesACellByTheValuesOfItsOwnAxes)
{
  const Workspace w;
  w.write("cases/bar/answers.csv", "error,answer_a,answer_b\n0,1,5\n0.5,1.5,5\n");
  ASSERT_EQ(mapped(w, R"toml(
[[accurate]]
name = "as large as the error"
take = {number = "largest"}
against = {number = "1 + axis_x0*axis_x1^2"}
norm = "absolute"
limit = 1e-9
maps = ["lists"]
[[accurate]]
name = "as the table has it"
take = {number = "largest"}
against = {csv = "answers.csv", of = "axis_y < 2 ? answer_a : answer_b", abscissa = "error", at = "axis_x"}
norm = "absolute"
limit = 1e-9
maps = ["numbers"]
[[map]]
name = "lists"
x = {label = "two at a time", set = ["fake.error={0}", "fake.h={1}"], values = [[0.0, 1.0], [0.5, 2.0]]}
[[map]]
name = "numbers"
x = {key = "fake.error", values = [0.0, 0.5]}
y = {key = "fake.h", values = [1.0, 3.0]}
)toml"),
            0);
  const auto maps = maps_of(w);
  for (const auto &cell : maps[0]["cells"])
    EXPECT_EQ(cell["class"], "accurate") << cell["why"];
  const auto &cells = maps[1]["cells"];
  EXPECT_EQ(cells[0]["class"], "accurate") << cells[0]["why"];
  EXPECT_EQ(cells[1]["class"], "accurate") << cells[1]["why"];
  EXPECT_EQ(cells[2]["class"], "bounded but wrong") << cells[2]["why"];
}

// Of a name with a slip no cell would ever be judged.
TEST(Stability, RefusesACheckOfAMapThatIsNotThere)
{
  const auto read = [](const std::string &name)
  {
    const Workspace w;
    return mapped(w, "[[accurate]]\ntake = {number = \"largest\"}\nagainst = {number = 1}\n"
                     "norm = \"absolute\"\nlimit = 0.1\nmaps = [\"" +
                         name + "\"]\n[[map]]\nname = \"m\"\n" +
                         "x = {key = \"fake.h\", values = [1]}\n" +
                         "[[map]]\nname = \"of the full suite\"\nsuites = [\"full\"]\n" +
                         "x = {key = \"fake.h\", values = [1]}\n");
  };
  EXPECT_EQ(read("m"), 0);
  EXPECT_THROW(read("M"), BadInput);
  EXPECT_EQ(read("of the full suite"), 1) << "the map of this suite is not judged";
}
