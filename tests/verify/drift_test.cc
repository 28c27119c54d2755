// accepted.toml: what it keeps, and when a value has drifted from it.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "drift.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  std::string run_with(const std::string &set)
  {
    return "[[run]]\nsolver = \"mpm_pf\"\nset = [" + set +
           "]\n[[run]]\nsolver = \"fe_reference\"\n";
  }

  /// A check of the number that a run with `fake.error` = e writes as 1 + e: its value is e.
  std::string check(const std::string &limit, const std::string &name = "c",
                    const std::string &solver = "mpm_pf")
  {
    return "[[check]]\nname = \"" + name + "\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = \"" +
           solver +
           "\", number = \"largest\"}\nagainst = {number = 1}\nnorm = \"relative\"\nlimit = " +
           limit + "\n";
  }

  /// Makes what a run with this setting gives the accepted values.
  Campaign accept(const Workspace &w, const std::string &set, const std::string &checks)
  {
    w.write("cases/bar/expect.toml", "title = \"bar\"\n" + run_with(set) + checks);
    const Campaign campaign = run_campaign(w.options(), w.paths());
    verify::accept(campaign);
    return campaign;
  }
} // namespace

TEST(Drift, IsReportedApartFromTheVerdict)
{
  const Workspace w;
  const std::string c = check("0.5");
  EXPECT_EQ(accept(w, "\"fake.error=0.1\"", c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=0.1\"") + c).exit_code, 0);
  const auto drifted = w.run(run_with("\"fake.error=0.12\"") + c);
  EXPECT_EQ(drifted.cases.at(0).verdicts.at(0).status, Status::pass);
  EXPECT_EQ(drifted.exit_code, 5);
}

TEST(Drift, OfRoundOffThatMovesIsNone)
{
  const Workspace w;
  const std::string c = check("1e-10");
  EXPECT_EQ(accept(w, "\"fake.error=1e-12\"", c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=3e-12\"") + c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=3e-11\"") + c).exit_code, 5);
}

TEST(Drift, OfRoundOffThatGrewFarBelowItsLimitIsSeen)
{
  const Workspace w;
  const std::string c = check("1e-8");
  EXPECT_EQ(accept(w, "\"fake.error=1e-13\"", c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=5e-12\"") + c).exit_code, 0)
      << "a thousandth of the limit";
  EXPECT_EQ(w.run(run_with("\"fake.error=5e-11\"") + c).exit_code, 5);
}

TEST(Drift, OfASmallErrorIsSeenBeforeItHasGrownToAHundredthOfItsLimit)
{
  const Workspace w;
  const std::string c = check("0.02");
  EXPECT_EQ(accept(w, "\"fake.error=1e-5\"", c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=1.5e-5\"") + c).exit_code, 0);
  EXPECT_EQ(w.run(run_with("\"fake.error=2e-4\"") + c).exit_code, 5);
}

// A machine without deal.II must not delete what was accepted of the finite elements.
TEST(Accepting, KeepsTheValuesOfWhatDidNotRunOrFailed)
{
  const Workspace w;
  w.write(
      "cases/bar/accepted.toml",
      "[full]\n\"c\" = 3.0\n[quick]\n\"c\" = 0.5\n\"fe\" = 0.25\n\"strict\" = 0.125\n\"gone\" = "
      "0.375\n");
  std::filesystem::remove(w.root / "bin" / "fe_reference");
  accept(w, "\"fake.error=0.1\"",
         check("1") + check("1", "fe", "fe_reference") + check("0.01", "strict"));
  const std::string file = w.read("cases/bar/accepted.toml");
  for (const char *line :
       {"[full]\n\"c\" = 3.0", "\"c\" = 0.1\n", "\"fe\" = 0.25\n", "\"strict\" = 0.125\n"})
    EXPECT_NE(file.find(line), std::string::npos) << line << "\n" << file;
  EXPECT_EQ(file.find("gone"), std::string::npos) << "expect.toml has no such check\n" << file;
}

TEST(Drift, FromNothingIsSaidAndFailsNothing)
{
  const Workspace w;
  w.write("cases/bar/accepted.toml", "[quick]\n\"c\" = 0.0\n");
  w.write("cases/bar/expect.toml",
          "title = \"bar\"\n" + run_with("") + check("1") + check("1", "another"));
  testing::internal::CaptureStdout();
  EXPECT_EQ(run(w.paths(), w.options()), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("1 checks passed without an accepted value"), std::string::npos) << said;
  const auto checks = nlohmann::json::parse(w.read("results/bar/verdict.json")).at("checks");
  EXPECT_EQ(checks.at(0).at("drift").at("status"), "same");
  EXPECT_EQ(checks.at(1).at("drift").at("status"), "no accepted value");
}

TEST(Accepting, TakesNoForecastForACheck)
{
  const Workspace w;
  accept(w, "", check("1"));
  const std::string file = w.read("cases/bar/accepted.toml");
  EXPECT_NE(file.find("\"c\" = "), std::string::npos) << file;
  EXPECT_EQ(file.find("forecast"), std::string::npos) << file;
}

TEST(Drift, FromWhatIsNoNumberIsRefusedBeforeAnythingRuns)
{
  for (const char *broken : {"[quick]\n\"c\" = nan\n", "[quick]\n\"c\" = inf\n",
                             "[full]\n\"c\" = \"one\"\n", "[quick\n"})
  {
    const Workspace w;
    w.write("cases/bar/accepted.toml", broken);
    try
    {
      w.run(run_with("") + check("1"));
      ADD_FAILURE() << broken;
    }
    catch (const BadInput &error)
    {
      EXPECT_NE(std::string(error.what()).find("accepted.toml"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(w.root / "results")) << broken;
  }
}
