// Trade and advice on the fake solver.
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

  /// The trade above, measured once for all tests.
  struct Measured
  {
    Workspace w;
    nlohmann::json result;
    Measured()
    {
      w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
      w.write("cases/bar/tradeoff.toml", trade);
      EXPECT_EQ(tradeoff(w.paths(), "bar", w.options()), 0);
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
  EXPECT_EQ(advise(w.paths(), {"bar", "largest", "4%", output}), 0);
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
  EXPECT_EQ(advise(w.paths(), {"bar", "largest", "0.01%", output}), 1);
  EXPECT_EQ(advise(w.paths(), {"bar", "largest", "4%", output + "/nothing"}), 4);
  EXPECT_THROW(advise(w.paths(), {"bar", "colour", "4%", output}), BadInput);
  EXPECT_THROW(advise(w.paths(), {"bar", "largest", "fast", output}), BadInput);
}

TEST(Tradeoff, FailsWhereNoRowHasAnError)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/tradeoff.toml",
          "[[quantity]]\nname = \"q\"\ntake = {number = \"no such\"}\nagainst = {number = 1}\n"
          "norms = [\"relative\"]\n[[family]]\nname = \"f\"\nlists = {\"fake.h\" = [1]}\n");
  EXPECT_EQ(tradeoff(w.paths(), "bar", w.options()), 1);
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
  EXPECT_EQ(tradeoff(w.paths(), "bar", w.options()), 2);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("a row of `f` was refused"), std::string::npos) << said;
  const auto rows = nlohmann::json::parse(w.read("results/tradeoff/bar.json"))["rows"];
  EXPECT_EQ(rows[0]["status"], "complete");
  EXPECT_EQ(rows[1]["status"], "bad input");
  EXPECT_NE(rows[1]["why"].dump().find("fake trouble of kind 2"), std::string::npos) << rows[1];
}

// The elements have an outline where the material points have a contour.
TEST(Tradeoff, TakesWhatElementsCallByAnotherName)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write("cases/bar/tradeoff.toml",
          "[[quantity]]\nname = \"q\"\ntake = {number = \"no such\"}\nagainst = {number = 2}\n"
          "take_fe_reference = {number = \"largest\"}\nnorms = [\"relative\"]\n"
          "[[family]]\nname = \"points\"\n"
          "[[family]]\nname = \"elements\"\nsolver = \"fe_reference\"\n");
  ASSERT_EQ(tradeoff(w.paths(), "bar", w.options()), 0);
  const auto rows = nlohmann::json::parse(w.read("results/tradeoff/bar.json"))["rows"];
  EXPECT_TRUE(rows[0]["errors"]["q, relative"].is_null());
  EXPECT_TRUE(rows[1]["errors"]["q, relative"].is_number());
}

// A row that found no room is no finding: said, and measured when there is some.
TEST(Tradeoff, MeasuresARowAgainThatCouldNotBeWritten)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
  w.write(
      "cases/bar/tradeoff.toml",
      "[[quantity]]\nname = \"q\"\ntake = {number = \"largest\"}\nagainst = {number = 1}\n"
      "norms = [\"relative\"]\n[[family]]\nname = \"f\"\nlists = {\"fake.exit\" = [0, 3, 6]}\n");
  for (int time = 0; time < 2; ++time)
  {
    testing::internal::CaptureStdout();
    EXPECT_EQ(tradeoff(w.paths(), "bar", w.options()), 6);
    const std::string said = testing::internal::GetCapturedStdout();
    EXPECT_NE(said.find("a row of `f` could not be written:\nfake trouble of kind 6"),
              std::string::npos)
        << said;
    const auto rows = nlohmann::json::parse(w.read("results/tradeoff/bar.json"))["rows"];
    EXPECT_EQ(rows[1]["status"], "diverged");
    EXPECT_EQ(rows[2]["status"], "not written");
  }
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
  ASSERT_EQ(tradeoff(w.paths(), "bar", w.options()), 0);
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
  EXPECT_EQ(advise(w.paths(), {"bar", "q", "5%", w.options().output}), 0);
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
    EXPECT_EQ(advise(w.paths(), {"bar", "largest", "4%", output}), 0);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_NE(told().find("measured " + old["provenance"]["start"].get<std::string>()),
            std::string::npos);
  EXPECT_EQ(told().find("warning"), std::string::npos);
  old["provenance"]["commit"] = "0123456";
  EXPECT_NE(told().find("warning: this program is of commit"), std::string::npos);
}
