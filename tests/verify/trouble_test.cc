// Campaigns in trouble: logs of any bytes, programs and disks that are not there, runs that wait
// for each other.
#include <system_error>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "record/command_line.h"
#include "section.h"
#include "stability_cells.h"
#include "workspace.h"

using namespace verify;

namespace
{
  const std::string lone_run = "[[run]]\nsolver = \"mpm_pf\"\n";

  std::string error_of(const std::string &runs)
  {
    const Workspace w;
    w.write("cases/bar/expect.toml", "title = \"bar\"\n" + runs);
    try
    {
      read_case(w.folder(), "quick");
    }
    catch (const BadInput &error)
    {
      return error.what();
    }
    return "";
  }

  std::string run_called(const std::string &name, const std::string &needs)
  {
    return "[[run]]\nname = \"" + name + "\"\nsolver = \"mpm_pf\"\nneeds = [" + needs + "]\n";
  }
} // namespace

TEST(Needs, InACircleAreRefused)
{
  const std::string both = error_of(run_called("a", "\"b\"") + run_called("b", "\"a\""));
  EXPECT_NE(both.find("run `a` can never start"), std::string::npos) << both;
  EXPECT_NE(both.find("run `b` can never start"), std::string::npos) << both;
  const std::string itself = error_of(run_called("a", "\"a\""));
  EXPECT_NE(itself.find("run `a` can never start"), std::string::npos) << itself;
  EXPECT_EQ(
      error_of(run_called("c", "\"a\", \"b\"") + run_called("b", "\"a\"") + run_called("a", "")),
      "");
}

TEST(Campaign, TellsTroubleAndTimeLimitOfARunThatMetBoth)
{
  const Workspace w;
  const auto campaign = w.run("[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.sleep=60\", "
                              "\"fake.troubled=1\"]\ntime_limit_s = 0.2\n");
  EXPECT_EQ(campaign.exit_code, 3);
  const Outcome &outcome = campaign.cases[0].outcomes[0];
  EXPECT_EQ(outcome.status, "diverged");
  for (const char *said : {"its time limit of 0.2 s", "fake trouble, going back"})
    EXPECT_NE(outcome.log_tail.find(said), std::string::npos) << outcome.log_tail;
  EXPECT_EQ(outcome.log_tail.find("a banner"), std::string::npos) << outcome.log_tail;
}

// A disk that was full says nothing of the numbers, and may have room again.
TEST(Campaign, TakesARunThatCouldNotWriteForNoneThatDiverged)
{
  const Workspace w;
  const std::string full = "[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.exit=6\"]\n";
  for (int time = 0; time < 2; ++time)
  {
    const auto campaign = w.run(full);
    EXPECT_EQ(campaign.exit_code, record::not_written);
    const Outcome &outcome = campaign.cases[0].outcomes[0];
    EXPECT_EQ(outcome.status, "not written");
    EXPECT_FALSE(outcome.reused);
    EXPECT_NE(outcome.log_tail.find("fake trouble of kind 6"), std::string::npos);
  }
  const auto and_another =
      w.run(full + "name = \"full\"\n[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.exit=3\"]\n");
  EXPECT_EQ(and_another.exit_code, record::not_written) << "room first, then the numbers";
}

TEST(Campaign, SurvivesALogOfAnyBytes)
{
  const Workspace w;
  const auto campaign =
      w.run("[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.bytes=1\", \"fake.exit=3\"]\n");
  EXPECT_EQ(campaign.exit_code, 3);
  for (const char *file : {"campaign.json", "bar/verdict.json", "bar/quick/mpm_pf.run.json"})
  {
    const auto json = nlohmann::json::parse(w.read(std::string("results/") + file), nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << file;
  }
  const std::string junit = w.read("results/junit.xml");
  EXPECT_NE(junit.find("fake trouble"), std::string::npos);
  EXPECT_NO_THROW(nlohmann::json(junit).dump()) << "no UTF-8";
}

TEST(Campaign, WithoutItsOnlyProgramDoesNotPass)
{
  const Workspace w;
  std::filesystem::remove(w.root / "bin" / "mpm_pf");
  EXPECT_EQ(w.run(lone_run).exit_code, 1);
  EXPECT_EQ(w.run("[[run]]\nsolver = \"mpm_pf\"\nexpect_exit = 2\n").exit_code, 1);
}

TEST(Campaign, NamesRecordsInFoldersThatLookLikeNames)
{
  const Workspace w;
  w.write("cases/bar/expect.toml",
          "title = \"bar\"\n" + run_called("first", "") +
              "[[run]]\nname = \"second\"\nsolver = \"mpm_pf\"\nneeds = [\"first\"]\n"
              "set = [\"body.path='{first} {first}'\"]\n");
  auto options = w.options();
  options.output = (w.root / "{first}").string();
  const auto campaign = run_campaign(options, w.paths());
  const std::string record = (w.root / "{first}/bar/quick/first.h5").string();
  EXPECT_EQ(campaign.cases[0].jobs[1].command.arguments.at(3),
            "body.path='" + record + " " + record + "'");
}

TEST(Campaign, KeepsTheAcceptedValuesWhereTheDiskIsFull)
{
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full here";
  const Workspace w;
  w.write("cases/bar/accepted.toml", "[quick]\n\"c\" = 1.0\n");
  w.write("cases/bar/expect.toml",
          "title = \"bar\"\n" + lone_run +
              "[[check]]\nname = \"c\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = \"mpm_pf\", "
              "number = \"largest\"}\nagainst = {number = 1}\nnorm = \"relative\"\nlimit = 0.5\n");
  std::filesystem::create_symlink("/dev/full", w.root / "cases/bar/accepted.toml.part");
  auto options = w.options();
  options.accept = true;
  EXPECT_THROW(run(w.paths(), options), BadInput);
  EXPECT_EQ(w.read("cases/bar/accepted.toml"), "[quick]\n\"c\" = 1.0\n");
  EXPECT_TRUE(std::filesystem::exists(w.root / "results/campaign.json")) << "the verdicts are lost";
}

TEST(List, NamesEveryCaseThoughOneIsBroken)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n" + lone_run);
  w.write("cases/a broken one/quick.toml", "");
  w.write("cases/a broken one/expect.toml", "title = \"broken\"\n");
  testing::internal::CaptureStdout();
  EXPECT_THROW(list(w.paths()), BadInput);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("runs: mpm_pf"), std::string::npos) << said;
}

TEST(List, OfAFolderWithoutCasesIsRefused)
{
  const Workspace w;
  EXPECT_THROW(list(w.paths()), BadInput); // bar has no expect.toml yet
}

TEST(Map, TakesAValueThatLooksLikeItsMark)
{
  const Workspace w;
  Stability stability;
  stability.c.name = "bar", stability.c.folder = w.folder(), stability.c.suite = "quick";
  Map map;
  map.name = "m", map.solver = "mpm_pf", map.scene = "quick.toml";
  map.x.set = {"title={value}"};
  const auto options = w.options();
  const Paths places = w.paths();
  const Mapper mapper{stability, places, options, (w.root / "runs").string()};
  EXPECT_EQ(mapper.cell(map, 0, "'{value}'", "").job.command.arguments.at(3), "title='{value}'");
}
