// What a user reads on the terminal and in files, and what goes on from where it was stopped.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "campaign_files.h"
#include "commands.h"
#include "drift.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  const std::string lone_run = "[[run]]\nsolver = \"mpm_pf\"\n";

  std::string check(const std::string &name)
  {
    return "[[check]]\nname = \"" + name +
           "\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = \"mpm_pf\", number = \"largest\"}\n"
           "against = {number = 1}\nnorm = \"relative\"\nlimit = 0.5\nunit = \"Pa\"\n";
  }

  /// What `verify run` prints.
  std::string printed(const Workspace &w, const std::string &expect)
  {
    w.write("cases/bar/expect.toml", "title = \"bar\"\n" + expect);
    w.write("postprocess/report.py", "");
    testing::internal::CaptureStdout();
    run(w.paths(), w.options());
    return testing::internal::GetCapturedStdout();
  }

  std::string refusal(const std::string &expect)
  {
    const Workspace w;
    w.write("cases/bar/expect.toml", "title = \"bar\"\n" + expect);
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

  bool holds(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace

TEST(Terminal, HasTheLastWordsOfARunAndItsLog)
{
  const Workspace w;
  const std::string text = printed(w, lone_run + "set = [\"fake.exit=3\"]\n");
  EXPECT_TRUE(holds(text, "| fake trouble of kind 3")) << text;
  EXPECT_TRUE(holds(text, "results/bar/quick/mpm_pf.log")) << text;
}

TEST(Terminal, NamesTheCasesOfEarlierCampaignsInTheFolder)
{
  const Workspace w;
  w.write("results/disc/verdict.json", "{}");
  const std::string text = printed(w, lone_run);
  EXPECT_TRUE(holds(text, "verdicts of earlier campaigns as well, of disc")) << text;
}

TEST(Terminal, PutsNoUnitOnARelativeValue)
{
  const Workspace w;
  EXPECT_FALSE(holds(printed(w, lone_run + check("c")), "Pa"));
  const auto json = nlohmann::json::parse(w.read("results/campaign.json"));
  EXPECT_EQ(json.at("cases")[0].at("checks")[0].at("value_unit"), "-");
  EXPECT_EQ(json.at("cases")[0].at("checks")[0].at("unit"), "Pa"); // of what was taken
}

TEST(Terminal, ShowsBothEndsOfAnInterval)
{
  Check of_a_number;
  of_a_number.norm = "value", of_a_number.low = 0., of_a_number.high = 5.;
  EXPECT_EQ(limit_text(of_a_number), "0 .. 5");
  of_a_number.norm = "absolute";
  EXPECT_EQ(limit_text(of_a_number), "5");
}

TEST(Cases, NamedTwiceAreRunOnce)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n" + lone_run);
  EXPECT_EQ(read_cases({"bar", "bar"}, "quick", w.paths()).size(), 1u);
  EXPECT_EQ(chosen_cases({"b", "a", "b"}, w.paths()), (std::vector<std::string>{"b", "a"}));
}

TEST(Runs, AreRefusedBeyondWhatTheyMayAskFor)
{
  for (const char *asked : {"threads = 0", "threads = 1.5", "processes = -3", "time_limit_s = 0",
                            "time_limit_s = -1", "name = \"../../x\"", "name = \"a\\nb\""})
  {
    const std::string key = std::string(asked).substr(0, std::string(asked).find(' '));
    const std::string text = refusal(lone_run + asked + "\n");
    EXPECT_TRUE(holds(text, key)) << asked << ": " << text;
    EXPECT_TRUE(holds(text, "expect.toml")) << asked << ": " << text;
  }
  EXPECT_EQ(refusal(lone_run + "threads = 2\nprocesses = 3\ntime_limit_s = 0.5\n"), "");
}

TEST(Accepting, ACheckWithALinesEndInItsNameCanBeReadAgain)
{
  const Workspace w;
  const std::string expect = lone_run + check("two\\nlines\\t\\u0007");
  w.write("cases/bar/expect.toml", "title = \"bar\"\n" + expect);
  accept(run_campaign(w.options(), w.paths()));
  const auto campaign = w.run(expect);
  EXPECT_TRUE(campaign.cases[0].verdicts[0].drift.accepted);
}

TEST(Jobs, GoOnFromTheCheckpointOfARunThatWasOutOfTime)
{
  const Workspace w;
  const std::string expect =
      lone_run + "set = [\"fake.sleep=30\", \"fake.checkpoint=1\"]\ntime_limit_s = 0.2\n";
  const auto first = w.run(expect);
  EXPECT_EQ(first.cases[0].outcomes[0].status, "timed out");
  const auto second = w.run(expect);
  EXPECT_EQ(second.cases[0].outcomes[0].status, "complete");
  EXPECT_GT(second.cases[0].outcomes[0].wall_s, first.cases[0].outcomes[0].wall_s);
}

TEST(Jobs, AreBegunAnewWhenThatIsAsked)
{
  const Workspace w;
  const std::string expect = "title = \"bar\"\n" + lone_run +
                             "set = [\"fake.sleep=30\", \"fake.checkpoint=1\"]\n"
                             "time_limit_s = 0.2\n";
  w.run(expect.substr(expect.find('\n') + 1));
  auto options = w.options();
  options.fresh = true;
  EXPECT_EQ(run_campaign(options, w.paths()).cases[0].outcomes[0].status, "timed out");
}

TEST(Advice, DistinguishesABrokenFileFromNone)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n" + lone_run);
  const AdviceRequest request{"bar", "largest", "2%", (w.root / "results").string()};
  testing::internal::CaptureStderr();
  EXPECT_EQ(advise(w.paths(), request), 4);
  EXPECT_TRUE(holds(testing::internal::GetCapturedStderr(), "is missing"));
  w.write("results/tradeoff/bar.json", "{\"half a fi");
  testing::internal::CaptureStderr();
  EXPECT_EQ(advise(w.paths(), request), 4);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(holds(said, "cannot be read")) << said;
}

TEST(Trade, SaysWhyNoRowHasAnError)
{
  const Workspace w;
  w.write("cases/bar/expect.toml", "title = \"bar\"\n" + lone_run);
  w.write("postprocess/report.py", "");
  w.write("cases/bar/tradeoff.toml", R"(
[[quantity]]
name    = "tip"
take    = {number = "no such number"}
against = {number = 1}
norms   = ["absolute"]
[[family]]
name  = "points"
lists = {"fake.h" = [1, 2.0]}
)");
  testing::internal::CaptureStdout();
  EXPECT_EQ(tradeoff(w.paths(), "bar", w.options()), 1);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(holds(text, "no row has an error in `tip, absolute`:\n  ")) << text;
  EXPECT_TRUE(holds(text.substr(text.find("no row")), "no such number")) << text;
}

TEST(Scripts, OfFiguresLookWhereTheCasesAre)
{
  const Workspace w;
  w.write("postprocess/figures.py", "import sys\nassert sys.argv[2] == '--cases'\n"
                                    "sys.exit(sys.argv[3] != '" +
                                        w.paths().cases + "')\n");
  EXPECT_EQ(figures(w.paths(), "anywhere"), 0);
}
