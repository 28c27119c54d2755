// What must not pass in silence: other times than those that are meant, lines that lie elsewhere,
// cases of which nothing is asked, checks that trip over their data.
#include <gtest/gtest.h>

#include "workspace.h"

using namespace verify;

namespace
{
  std::string check(const std::string &take, const std::string &against, const std::string &norm)
  {
    return "[[check]]\nname = \"c\"\nsource = \"s\"\nreason = \"r\"\ntake = {run = \"mpm_pf\", " +
           take + "}\nagainst = " + against + "\nnorm = \"" + norm + "\"\nlimit = 1\n";
  }
  std::string runs(const std::string &set, const std::string &of_elements = "")
  {
    return "[[run]]\nsolver = \"mpm_pf\"\nset = [" + set +
           "]\n[[run]]\nsolver = \"fe_reference\"\nset = [" + of_elements + "]\n";
  }
  const Verdict &only(const Campaign &campaign)
  {
    return campaign.cases.at(0).verdicts.at(0);
  }
  const std::string elements = "{run = \"fe_reference\"}";
} // namespace

TEST(TheEnd, OfALineAnOutlineAndASnapshotIsThatOfTheRun)
{
  const Workspace w;
  const std::string checks[] = {
      check("line = \"profile\", of = \"u\"", "{formula = \"x^2\"}", "max"),
      check("outline = \"outline\", of = \"area\"", "{number = 1}", "absolute"),
      check("snapshot = \"fields\", of = \"sum\", reduce = \"min\"", "\"zero\"", "absolute")};
  for (const auto &c : checks)
  {
    EXPECT_EQ(only(w.run(runs("") + c)).status, Status::pass) << c;
    const Campaign early = w.run(runs("\"fake.recorded=0.99\"") + c);
    EXPECT_EQ(only(early).status, Status::missing) << c;
    EXPECT_NE(only(early).why.find("recorded until time 0.99"), std::string::npos)
        << only(early).why;
  }
}

TEST(TheEnd, OfTwoRunsIsOneTime)
{
  const Workspace w;
  const std::string half = "\"fake.end=0.5\", \"fake.recorded=0.5\", \"fake.short=0.5\"";
  for (const auto &c :
       {check("line = \"profile\", of = \"u\"", elements, "max"),
        check("table = \"history\", of = \"strain\", at = \"end\"", elements, "absolute")})
  {
    EXPECT_EQ(only(w.run(runs("") + c)).status, Status::pass) << c;
    const Campaign unlike = w.run(runs("", half) + c);
    EXPECT_EQ(only(unlike).status, Status::missing) << c;
    EXPECT_NE(only(unlike).why.find("of time 1, what it is held against of time 0.5"),
              std::string::npos)
        << only(unlike).why;
  }
  EXPECT_EQ(only(w.run(runs("", half) + check("line = \"profile\", of = \"u\", at = 1",
                                              "{run = \"fe_reference\", at = 0.5}", "max")))
                .status,
            Status::pass)
      << "both times are said";
}

TEST(Reductions, OfALineNeedMaterialAlongIt)
{
  const Workspace w;
  const auto status = [&](const std::string &how, const std::string &rest)
  {
    return only(w.run(runs("\"fake.bare=10\"") +
                      check("line = \"profile\", of = \"u\", reduce = \"" + how + "\"", "\"zero\"",
                            "absolute") +
                      rest))
        .status;
  };
  EXPECT_EQ(status("mean", ""), Status::missing);
  EXPECT_EQ(status("mean", "coverage = 0.5\n"), Status::pass) << "11 of 21";
  EXPECT_EQ(status("last", ""), Status::pass) << "where material is";
}

TEST(Campaign, OfACaseOfWhichNothingIsAskedFails)
{
  const Workspace w;
  const Campaign silent = w.run(runs(""));
  EXPECT_EQ(silent.exit_code, 1);
  EXPECT_NE(only(silent).why.find("no [[check]] for suite quick"), std::string::npos)
      << only(silent).why;
}

TEST(Campaign, WithoutAnyProgramLacksMoreThanItsReference)
{
  const Workspace w;
  for (const char *solver : {"mpm_pf", "fe_reference"})
    std::filesystem::remove(w.root / "bin" / solver);
  EXPECT_EQ(w.run(runs("") + check("number = \"largest\"", elements, "relative")).exit_code, 1);
}

TEST(Campaign, DrawsFieldsThatHaveDiedAway)
{
  const Workspace w;
  const Campaign campaign =
      w.run(runs("") + check("table = \"history\", of = \"force*1e-300*1e-10\"",
                             "{formula = \"sin(x)*1e-300*2e-10\"}", "max"));
  EXPECT_EQ(campaign.exit_code, 0) << only(campaign).why;
}

// Records and tables may change under a check that was in order when it was read.
TEST(Judge, TellsWhatItTripsOver)
{
  const Workspace w;
  const Campaign campaign =
      w.run(runs("") + check("table = \"history\", of = \"force\", at = 1", elements, "relative"));
  const CaseResult &result = campaign.cases.at(0);
  Records records((w.root / "results/bar/quick").string(), {});
  Check broken = result.c.checks.at(0);
  EXPECT_EQ(judge(broken, result.c, records).status, Status::pass);
  broken.take.of = "force +* 2";
  const Verdict verdict = judge(broken, result.c, records);
  EXPECT_EQ(verdict.status, Status::missing);
  EXPECT_NE(verdict.why.find("force +* 2"), std::string::npos) << verdict.why;
}
