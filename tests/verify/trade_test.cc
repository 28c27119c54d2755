// Trade, advice and stability maps on the fake solver.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  // error 0.1 h^2; the finer row burns more
  const std::string trade = R"(
time_limit_s = 20
[[reference]]
solver = "fe_reference"
set = ["fake.error=1e-4", "fake.h=1"]
h = 1
[[reference]]
solver = "fe_reference"
set = ["fake.error=1e-4", "fake.h=2"]
h = 2
[[reference]]
solver = "fe_reference"
set = ["fake.error=1e-4", "fake.h=4"]
h = 4
[[quantity]]
name = "largest"
take = {number = "largest"}
norms = ["absolute", "relative"]
[[family]]
name = "points"
set = ["fake.error=0.1"]
lists = {"fake.h" = [1, 2.0]}
[[family]]
name = "finer points"
set = ["fake.error=0.1", "fake.h=0.5"]
lists = {"fake.burn" = [0.15]}
[[family]]
name = "finest points"
set = ["fake.error=0.1", "fake.h=0.25"]
lists = {"fake.burn" = [0.6]}
[[family]]
name = "broken"
lists = {"fake.exit" = [3]}
)";

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
[[map]]
name = "exits"
x = {key = "fake.exit", values = [2, 3]}
[[map]]
name = "lists"
x = {key = "fake.growth", values = [0.0, 8.0]}
y = {label = "two at a time", set = ["fake.error={0}", "fake.h={1}"], values = [[0.0, 0.25]]}
theory = "4*log(10)*(y0 + 2*y1)"
)toml";

  /// The trade above, measured once for all tests.
  struct Measured
  {
    Workspace w;
    nlohmann::json result;
    Measured()
    {
      w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
      w.write("cases/bar/tradeoff.toml", trade);
      EXPECT_EQ(tradeoff(w.places(), "bar", w.options()), 0);
      result = nlohmann::json::parse(w.read("results/tradeoff/bar.json"));
    }
  };
  const Measured &measured()
  {
    static const Measured once;
    return once;
  }
} // namespace

TEST(Tradeoff, MultipliesListsAndMeasuresErrorAndCost)
{
  const auto &result = measured().result;
  ASSERT_EQ(result["rows"].size(), 5u);
  EXPECT_EQ(result["measures"],
            (std::vector<std::string>{"largest, absolute", "largest, relative"}));
  const auto &first = result["rows"][0];
  EXPECT_NEAR(first["errors"]["largest, absolute"].get<double>(), 0.1 - 1e-4, 1e-9);
  EXPECT_EQ(first["settings"]["fake.h"], "1");
  EXPECT_EQ(result["rows"][2]["settings"]["fake.burn"], "0.15");
  EXPECT_GE(first["cpu_spread_s"].get<double>(), 0.);
  // grids of the reference: error 1e-4 h^2, index 1.25e-4 at h = 1
  EXPECT_NEAR(result["reference"]["uncertainty"]["largest, absolute"].get<double>(), 1.25e-4, 1e-8);
  const auto &broken = result["rows"][4];
  EXPECT_EQ(broken["status"], "diverged");
  EXPECT_TRUE(broken["errors"]["largest, absolute"].is_null());
}

TEST(Advice, IsTheCheapestMeasuredRowAndItsRerunMeetsTheError)
{
  const Workspace &w = measured().w;
  const std::string output = w.options().output;
  testing::internal::CaptureStdout();
  EXPECT_EQ(advise(w.places(), "bar", "largest", "4%", output), 0);
  const std::string advice = testing::internal::GetCapturedStdout();
  // 0.1 h^2 = 0.025 at h = 0.5 (0.15 s) meets 0.04/1.25 = 0.032, h = 1 does not
  EXPECT_NE(advice.find("h=0.5"), std::string::npos) << advice;
  EXPECT_NE(advice.find("[fake]"), std::string::npos) << advice;
  const auto rerun =
      w.run("[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.error=0.1\", "
            "\"fake.h=0.5\"]\n[[check]]\nname = \"c\"\nsource = \"s\"\n"
            "reason = \"r\"\ntake = {run = \"mpm_pf\", number = \"largest\"}\nagainst = {number = "
            "1}\nnorm = \"absolute\"\nlimit = 0.04\n");
  EXPECT_EQ(rerun.exit_code, 0);
}

TEST(Advice, NeverExtrapolates)
{
  const Workspace &w = measured().w;
  const std::string output = w.options().output;
  EXPECT_EQ(advise(w.places(), "bar", "largest", "0.01%", output), 1);
  EXPECT_EQ(advise(w.places(), "bar", "largest", "4%", output + "/nothing"), 4);
  EXPECT_THROW(advise(w.places(), "bar", "colour", "4%", output), BadInput);
  EXPECT_THROW(advise(w.places(), "bar", "largest", "fast", output), BadInput);
}

TEST(Stability, TellsTheClassesApartAndFindsTheEdge)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/stability.toml", extremes);
  CampaignOptions options = w.options();
  options.cases = {"bar"};
  ASSERT_EQ(stability(w.places(), options), 0);
  const auto result = nlohmann::json::parse(w.read("results/stability/bar.json"));
  const auto &cells = result["maps"][0]["cells"];
  EXPECT_EQ(cells[0]["class"], "accurate");
  EXPECT_EQ(cells[1]["class"], "growing energy");
  EXPECT_EQ(cells[2]["class"], "bounded but wrong");
  EXPECT_EQ(result["maps"][1]["cells"][0]["class"], "refused");
  EXPECT_EQ(result["maps"][1]["cells"][1]["class"], "diverged");
  EXPECT_NE(cells[0]["repeat"].get<std::string>().find("fake.growth=0"), std::string::npos);
  // exp(g)/exp(g/2) = 10 at g = 2 log 10 = 4.605
  const auto &edge = result["maps"][0]["edges"][0];
  EXPECT_LE(edge["stable"].get<double>(), 4.61);
  EXPECT_GE(edge["unstable"].get<double>(), 4.60);
  EXPECT_LT(edge["unstable"].get<double>() - edge["stable"].get<double>(), 0.2);
  EXPECT_NEAR(edge["theory"].get<double>(), 4.605, 1e-3);
  // a theory knows the entries of a list
  EXPECT_NEAR(result["maps"][2]["edges"][0]["theory"].get<double>(), 4.605, 1e-3);
}

TEST(Stability, TakesRunsOutOfTimeAndRefusedOnesForNeitherStableNorUnstable)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/stability.toml", judged + R"toml(
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
)toml");
  CampaignOptions options = w.options();
  options.cases = {"bar"};
  ASSERT_EQ(stability(w.places(), options), 0);
  const auto maps = nlohmann::json::parse(w.read("results/stability/bar.json"))["maps"];
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
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/stability.toml", "[[map]]\nname = \"m\"\nset = [\"fake.exit=2\"]\n"
                                      "x = {key = \"fake.h\", values = [1, 2]}\n");
  CampaignOptions options = w.options();
  options.cases = {"bar"};
  EXPECT_EQ(stability(w.places(), options), 1);
}

TEST(Tradeoff, FailsWhereNoRowHasAnError)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/tradeoff.toml",
          "[[quantity]]\nname = \"q\"\ntake = {number = \"no such\"}\nagainst = {number = 1}\n"
          "norms = [\"relative\"]\n[[family]]\nname = \"f\"\nlists = {\"fake.h\" = [1]}\n");
  EXPECT_EQ(tradeoff(w.places(), "bar", w.options()), 1);
}

// What is refused is no point of a trade: a key that is gone would otherwise fade from the page.
TEST(Tradeoff, FailsWhereARowIsRefusedAndSaysWhy)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/tradeoff.toml",
          "[[quantity]]\nname = \"q\"\ntake = {number = \"largest\"}\nagainst = {number = 1}\n"
          "norms = [\"relative\"]\n[[family]]\nname = \"f\"\nlists = {\"fake.exit\" = [0, 2]}\n");
  testing::internal::CaptureStdout();
  EXPECT_EQ(tradeoff(w.places(), "bar", w.options()), 2);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("a row of `f` was refused"), std::string::npos) << said;
  const auto rows = nlohmann::json::parse(w.read("results/tradeoff/bar.json"))["rows"];
  EXPECT_EQ(rows[0]["status"], "complete");
  EXPECT_EQ(rows[1]["status"], "bad input");
  EXPECT_NE(rows[1]["why"].dump().find("fake trouble of kind 2"), std::string::npos) << rows[1];
}

TEST(Advice, CallsTheErrorOfALoneReferenceUnknown)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/tradeoff.toml",
          "[[reference]]\nsolver = \"fe_reference\"\nh = 1\n"
          "[[quantity]]\nname = \"q\"\ntake = {number = \"largest\"}\nnorms = [\"relative\"]\n"
          "[[quantity]]\nname = \"theory\"\ntake = {number = \"largest\"}\nnorms = [\"relative\"]\n"
          "against = {number = 1}\n[[family]]\nname = \"points\"\nset = [\"fake.error=0.01\"]\n"
          "[[family]]\nname = \"elements\"\nsolver = \"fe_reference\"\n");
  ASSERT_EQ(tradeoff(w.places(), "bar", w.options()), 0);
  const auto result = nlohmann::json::parse(w.read("results/tradeoff/bar.json"));
  const auto &reference = result["reference"];
  EXPECT_TRUE(reference["uncertainty"].at("q, relative").is_null());
  EXPECT_FALSE(reference["uncertainty"].contains("theory, relative"));
  EXPECT_EQ(reference["against"]["q, relative"], "finite elements");
  EXPECT_EQ(reference["against"]["theory, relative"], "theory");
  // finite elements against finite elements would be 0: nothing was measured
  EXPECT_TRUE(result["rows"][1]["errors"]["q, relative"].is_null());
  EXPECT_EQ(result["rows"][1]["errors"]["theory, relative"], 0.);
  testing::internal::CaptureStdout();
  EXPECT_EQ(advise(w.places(), "bar", "q", "5%", w.options().output), 0);
  const std::string advice = testing::internal::GetCapturedStdout();
  EXPECT_NE(advice.find("uncertainty of the reference unknown"), std::string::npos) << advice;
  EXPECT_NE(advice.find("nobody measured"), std::string::npos) << advice;
}

TEST(Advice, TellsWhenItWasMeasuredAndWarnsOfAnotherProgram)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  const std::string output = w.options().output;
  auto old = measured().result;
  const auto told = [&]
  {
    w.write("results/tradeoff/bar.json", old.dump());
    testing::internal::CaptureStdout();
    EXPECT_EQ(advise(w.places(), "bar", "largest", "4%", output), 0);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_NE(told().find("measured " + old["provenance"]["start"].get<std::string>()),
            std::string::npos);
  EXPECT_EQ(told().find("warning"), std::string::npos);
  old["provenance"]["commit"] = "0123456";
  EXPECT_NE(told().find("warning: this program is of commit"), std::string::npos);
}
