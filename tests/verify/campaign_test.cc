// Whole campaigns on the fake solver: what passes, what fails, what is missing, what is kept.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "campaign_files.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  const std::string two_runs = "[[run]]\nsolver = \"mpm_pf\"\n[[run]]\nsolver = \"fe_reference\"\n";

  std::string check(const std::string &take, const std::string &against, const std::string &norm,
                    const std::string &limit)
  {
    return "[[check]]\nname = \"c\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = \"mpm_pf\", " +
           take + "}\n" + (against.empty() ? "" : "against = " + against + "\n") + "norm = \"" +
           norm + "\"\nlimit = " + limit + "\n";
  }
  const Verdict &only(const Campaign &campaign)
  {
    return campaign.cases.at(0).verdicts.at(0);
  }
  std::string run_with(const std::string &set)
  {
    return "[[run]]\nsolver = \"mpm_pf\"\nset = [" + set +
           "]\n[[run]]\nsolver = \"fe_reference\"\n";
  }
} // namespace

TEST(Campaign, PassesEqualRunsInEveryKindOfProbe)
{
  const Workspace w;
  const struct
  {
    std::string take, against, norm;
  } kinds[] = {
      {"table = \"history\", of = \"force/2\"", "{run = \"fe_reference\"}", "relative_max"},
      {"table = \"history\", of = \"force\", abscissa = \"strain\"", "{run = \"fe_reference\"}",
       "relative_l2"},
      {"table = \"history\", of = \"force/2\"", "{formula = \"sin(x)\"}", "relative_rms"},
      {"table = \"history\", of = \"force\", at = 0.5", "{number = \"2*sin(0.5)\"}", "relative"},
      {"table = {a = \"history\", b = \"energy\"}, of = \"a_force*b_kinetic_energy\"",
       "{formula = \"2*sin(t)\"}", "max"},
      {"line = \"profile\", of = \"u\"", "{formula = \"x^2\"}", "max"},
      {"outline = \"outline\"", "{run = \"fe_reference\"}", "symmetric_difference"},
      {"outline = \"outline\", of = \"side\", side = \"right\", y = 0.9", "{number = 1}",
       "absolute"},
      {"snapshot = \"fields\", of = \"sum - x - y\", reduce = \"max_abs\"", "\"zero\"", "absolute"},
      {"snapshot = \"fields\", of = \"sum\", bin = 1", "{run = \"fe_reference\"}", "max"},
      {"number = \"largest\"", "{number = 1}", "relative"}};
  for (const auto &kind : kinds)
  {
    const auto campaign = w.run(two_runs + check(kind.take, kind.against, kind.norm, "1e-6"));
    EXPECT_EQ(campaign.exit_code, 0) << kind.take << ": " << only(campaign).why;
  }
}

// Squares of a box are those of the whole there: 1 and 2 of 0, 1, 1, 2.
TEST(Campaign, AveragesWhatABoxHoldsWhereItIs)
{
  const Workspace w;
  const auto campaign = w.run(
      two_runs + check("snapshot = \"fields\", of = \"sum\", bin = 1, box = [[0.5, -1], [2, 2]]",
                       "{run = \"fe_reference\", box = [[-1, -1], [2, 2]]}", "max",
                       "1e-6\ncoverage = 0.5"));
  EXPECT_EQ(only(campaign).status, Status::pass) << only(campaign).why;
}

// A crystal turned the wrong way round must not pass for the right one.
TEST(Campaign, MirrorsAnOutlineThatIsOnlySymmetricUnderHalfATurn)
{
  const Workspace w;
  const std::string runs = "[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.skew=0.8\"]\n"
                           "[[run]]\nsolver = \"fe_reference\"\nset = [\"fake.skew=-0.8\"]\n";
  const auto status = [&](const std::string &keys, const std::string &of_other)
  {
    const auto campaign = w.run(runs + check("outline = \"outline\"" + keys,
                                             "{run = \"fe_reference\"" + of_other + "}",
                                             "relative_symmetric_difference", "0.01"));
    return only(campaign).status;
  };
  EXPECT_EQ(status("", ""), Status::fail);
  EXPECT_EQ(status(", rotate = 180", ", rotate = 0"), Status::fail);
  EXPECT_EQ(status(", mirror = \"x\"", ", mirror = \"none\""), Status::pass);
  EXPECT_EQ(status("", ", mirror = \"y\""), Status::pass);
  EXPECT_EQ(status(", mirror = \"x\"", ""), Status::fail) << "both are mirrored";
  // first mirrored, then turned, then moved: the other's turn and move are the same ones
  EXPECT_EQ(status(", mirror = \"x\", rotate = 30, shift = [5, 1]", ", mirror = \"none\""),
            Status::pass);
}

TEST(Campaign, FailsOnEitherSideOfTheReference)
{
  const Workspace w;
  for (const char *error : {"0.05", "-0.05"})
  {
    const auto campaign = w.run(run_with("\"fake.error=" + std::string(error) + "\"") +
                                check("table = \"history\", of = \"force\"",
                                      "{run = \"fe_reference\"}", "relative_max", "0.04"));
    EXPECT_EQ(campaign.exit_code, 1);
    EXPECT_EQ(only(campaign).status, Status::fail);
    EXPECT_NEAR(*only(campaign).value, 0.05, 1e-6);
  }
}

TEST(Campaign, NeverPassesMissingShortOrInfiniteData)
{
  const Workspace w;
  const std::string line =
      check("line = \"profile\", of = \"u\"", "{formula = \"x^2\"}", "max", "1");
  const std::string history =
      check("table = \"history\", of = \"force\"", "{run = \"fe_reference\"}", "max", "1");
  EXPECT_EQ(only(w.run(run_with("\"fake.nan=1\"") + line)).status, Status::missing);
  EXPECT_EQ(only(w.run(run_with("\"fake.short=0.7\"") + history)).status, Status::missing);
  EXPECT_EQ(only(w.run(two_runs + check("line = \"no such\", of = \"u\"", "\"zero\"", "max", "9")))
                .status,
            Status::missing);
  EXPECT_EQ(only(w.run(two_runs + check("line = \"profile\", of = \"w\"", "\"zero\"", "max", "9")))
                .status,
            Status::missing);
  EXPECT_EQ(
      w.run(two_runs + check("number = \"no such\"", "{number = 1}", "absolute", "9")).exit_code,
      1);
}

TEST(Campaign, TakesNothingWholeOfAHistoryThatStopsBeforeTheClock)
{
  const Workspace w;
  const std::string end =
      check("table = \"history\", of = \"force\", at = \"end\"", "\"zero\"", "absolute", "9");
  EXPECT_EQ(only(w.run(two_runs + end)).status, Status::pass);
  EXPECT_EQ(only(w.run(run_with("\"fake.short=0.995\"") + end)).status, Status::pass) << "one row";
  const auto shorter = w.run(run_with("\"fake.short=0.7\"") + end);
  EXPECT_EQ(only(shorter).status, Status::missing);
  EXPECT_NE(only(shorter).why.find("the clock ends at 1"), std::string::npos) << only(shorter).why;
  // a formula is wherever the history is, and would miss nothing
  const std::string formula =
      check("table = \"history\", of = \"force/2\"", "{formula = \"sin(x)\"}", "max", "1");
  EXPECT_EQ(only(w.run(two_runs + formula)).status, Status::pass);
  EXPECT_EQ(only(w.run(run_with("\"fake.short=0.7\"") + formula)).status, Status::missing);
  const std::string stretch = check("table = \"history\", of = \"force/2\", between = [0, 0.6]",
                                    "{formula = \"sin(x)\"}", "max", "1");
  EXPECT_EQ(only(w.run(run_with("\"fake.short=0.7\"") + stretch)).status, Status::pass);
}

TEST(Campaign, LetsOnlyWallsThatMoveEndARunBeforeTheClock)
{
  const Workspace w;
  const std::string end =
      check("table = \"history\", of = \"force\", at = \"end\"", "\"zero\"", "absolute", "9");
  const auto status = [&](const std::string &wall)
  { return only(w.run(run_with("\"fake.short=0.7\", " + wall) + end)).status; };
  EXPECT_EQ(status("\"fake.wall_travel=0.5\", \"fake.wall_speed=2\""), Status::pass);
  EXPECT_EQ(status("\"fake.wall_travel=0\", \"fake.wall_speed=0\""), Status::missing);
  EXPECT_EQ(status("\"fake.wall_travel=0.5\", \"fake.wall_speed=0\""), Status::missing);
}

TEST(Campaign, ExitCodesTellBadInputDivergenceAndMissingReferencesApart)
{
  const Workspace w;
  const std::string c =
      check("table = \"history\", of = \"force\"", "{run = \"fe_reference\"}", "max", "1");
  EXPECT_EQ(w.run(run_with("\"fake.exit=3\"") + c).exit_code, 3);
  EXPECT_EQ(w.run(run_with("\"fake.exit=2\"") + c).exit_code, 2);
  const std::string csv = "{csv = \"absent.csv\", of = \"a\"}";
  EXPECT_EQ(
      w.run(two_runs + check("table = \"history\", of = \"force\"", csv, "max", "1")).exit_code, 4);
  const Workspace without;
  std::filesystem::remove(without.root / "bin" / "fe_reference");
  EXPECT_EQ(without.run(two_runs + c).exit_code, 4);
}

TEST(Campaign, ReadsReferenceTables)
{
  const Workspace w;
  w.write("cases/bar/reference.csv", "# sin\ntime,value\n0,0\n0.5,0.4794255386\n1,0.8414709848\n");
  const auto campaign =
      w.run(two_runs + check("table = \"history\", of = \"force/2\"",
                             "{csv = \"reference.csv\", of = \"value\"}", "max", "1e-6"));
  EXPECT_EQ(campaign.exit_code, 0) << only(campaign).why;
}

TEST(Campaign, AcceptsARunThatMustFailAndSaysWhy)
{
  const Workspace w;
  const std::string run =
      "[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.exit=2\"]\nexpect_exit = 2\n";
  EXPECT_EQ(w.run(run + "expect_output = \"kind 2\"\n").exit_code, 0);
  EXPECT_EQ(w.run(run + "expect_output = \"another\"\n").exit_code, 1);
}

TEST(Campaign, KillsWhatRunsTooLong)
{
  const Workspace w;
  const auto campaign =
      w.run("[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.sleep=60\"]\ntime_limit_s = 0.2\n");
  EXPECT_EQ(campaign.exit_code, 3);
  EXPECT_EQ(campaign.cases[0].outcomes[0].status, "timed out");
  EXPECT_LT(campaign.wall_s, 10.);
}

TEST(Campaign, KeepsFinishedRunsUntilSettingsOrSceneChange)
{
  const Workspace w;
  EXPECT_FALSE(w.run(two_runs).cases[0].outcomes[0].reused);
  EXPECT_TRUE(w.run(two_runs).cases[0].outcomes[0].reused);
  const auto changed = w.run(run_with("\"fake.error=1\""));
  EXPECT_FALSE(changed.cases[0].outcomes[0].reused);
  EXPECT_TRUE(changed.cases[0].outcomes[1].reused);
  w.write("cases/bar/quick.toml", "title = \"another\"\n");
  EXPECT_FALSE(w.run(run_with("\"fake.error=1\"")).cases[0].outcomes[1].reused);
  std::filesystem::remove(w.root / "results/bar/quick/mpm_pf.h5");
  EXPECT_FALSE(w.run(run_with("\"fake.error=1\"")).cases[0].outcomes[0].reused);
}

TEST(Campaign, MeasuresAnOrderAndTheUncertaintyOfBothCodes)
{
  const Workspace w;
  std::string runs;
  for (const char *h : {"4", "2", "1"})
    for (const char *solver : {"mpm_pf", "fe_reference"})
      runs += std::string("[[run]]\nsolver = \"") + solver + "\"\nname = \"" + solver + h +
              "\"\nh = " + h + "\nset = [\"fake.error=" + (solver[0] == 'm' ? "1e-2" : "1e-3") +
              "\", \"fake.h=" + h + "\"]\n";
  const auto campaign =
      w.run(runs + "[[check]]\nname = \"order\"\nsource = \"s\"\nreason = \"r\"\norder_over = "
                   "[\"mpm_pf1\", \"mpm_pf2\", \"mpm_pf4\"]\n"
                   "take = {line = \"profile\", of = \"u\"}\nagainst = {formula = \"x^2\"}\nnorm = "
                   "\"l2\"\nlimit = [1.9, 2.1]\n"
                   "[[check]]\nname = \"value\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = "
                   "\"mpm_pf1\", line = \"profile\", of = \"u\"}\n"
                   "against = {run = \"fe_reference1\"}\nnorm = \"max\"\nlimit = 0.02\n"
                   "uncertainty = {take = [\"mpm_pf1\", \"mpm_pf2\", \"mpm_pf4\"], against = "
                   "[\"fe_reference1\", \"fe_reference2\", \"fe_reference4\"]}\n");
  ASSERT_EQ(campaign.exit_code, 0);
  EXPECT_NEAR(*campaign.cases[0].verdicts[0].value, 2., 1e-6);
  // errors 1e-2 h^2 and 1e-3 h^2 at h = 1, safety 1.25, added as squares
  EXPECT_NEAR(*campaign.cases[0].verdicts[1].value, 9e-3, 1e-9);
  EXPECT_NEAR(*campaign.cases[0].verdicts[1].uncertainty, 1.25 * std::hypot(1e-2, 1e-3), 1e-6);
}

TEST(Campaign, RunsWhatNeedsAnotherRunAfterIt)
{
  const Workspace w;
  const auto campaign =
      w.run("[[run]]\nname = \"second\"\nsolver = \"mpm_pf\"\nneeds = [\"first\"]\nset = "
            "[\"body.path='{first}'\"]\n"
            "[[run]]\nname = \"first\"\nsolver = \"mpm_pf\"\nset = [\"fake.sleep=0.2\"]\n");
  EXPECT_TRUE(campaign.cases[0].outcomes[0].good());
  const std::string command = campaign.cases[0].jobs[0].command.arguments.at(3);
  EXPECT_NE(command.find("first.h5"), std::string::npos) << command;
}

TEST(Campaign, WritesVerdictsThatOthersCanRead)
{
  const Workspace w;
  w.run(run_with("\"fake.error=0.1\"") + check("table = \"history\", of = \"force\"",
                                               "{run = \"fe_reference\"}", "relative_max", "0.01"));
  const auto verdict = nlohmann::json::parse(w.read("results/bar/verdict.json"));
  const auto &c = verdict.at("checks").at(0);
  for (const char *key : {"name", "take", "against", "norm", "value", "limit", "unit",
                          "uncertainty", "status", "source"})
    EXPECT_TRUE(c.contains(key)) << key;
  EXPECT_EQ(c.at("status"), "fail");
  EXPECT_NE(
      c.at("repeat").get<std::string>().find("verify --cases elsewhere run bar --suite quick"),
      std::string::npos);
  const auto &run = verdict.at("runs").at(0);
  for (const char *key : {"solver", "scene", "status", "wall_s", "cpu_s", "peak_rss_bytes", "steps",
                          "cells", "points", "build_type"})
    EXPECT_TRUE(run.contains(key)) << key;
  EXPECT_EQ(run.at("steps"), 100);
  EXPECT_EQ(run.at("inertia"), "inertia shows: not quasi-static");
  EXPECT_FALSE(verdict.at("runs").at(1).contains("inertia"));
  EXPECT_NE(w.read("results/junit.xml").find("property name=\"value\" value=\"0.1"),
            std::string::npos);
}

TEST(Campaign, HasItsFolderToItself)
{
  const Workspace w;
  const record::Lock other = lock_output((w.root / "results").string());
  try
  {
    w.run(two_runs);
    FAIL() << "two campaigns in one folder";
  }
  catch (const BadInput &error)
  {
    EXPECT_NE(std::string(error.what()).find("in use by process " + std::to_string(getpid())),
              std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(w.root / "results" / "bar")) << "a run was started";
}
