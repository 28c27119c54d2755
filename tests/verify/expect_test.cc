// expect.toml: every error of a file at once, with its place and what to do.
#include <gtest/gtest.h>

#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  std::string error_of(const std::string &expect)
  {
    return Workspace().said_of(expect);
  }
  const std::string head = "title = \"t\"\n[[run]]\nsolver = \"mpm_pf\"\n";
  const std::string check = "[[check]]\nname = \"c\"\nsource = \"s\"\nreason = \"r\"\n";
} // namespace

TEST(Expectations, NameAnUnknownKeyAndTheNearestKnownOne)
{
  const std::string text = error_of(head + "expect_exitt = 2\n");
  EXPECT_NE(text.find("expect_exitt"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean `expect_exit`"), std::string::npos) << text;
  EXPECT_NE(text.find("expect.toml"), std::string::npos) << text;
}

TEST(Expectations, ReportAllErrorsInOnePass)
{
  const std::string text =
      error_of("[[run]]\nsolver = \"abaqus\"\n" + check +
               "take = {run = \"nobody\", line = \"l\"}\nnorm = \"biggest\"\nlimit = 1\n");
  for (const char *part :
       {"`title` is missing", "mpm_pf", "no such norm", "`of` is missing", "nobody"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Expectations, WantTwoSidedLimitsOfValuesAndOrders)
{
  const std::string text = error_of(
      head + check + "take = {run = \"mpm_pf\", number = \"n\"}\nnorm = \"value\"\nlimit = 1\n");
  EXPECT_NE(text.find("two-sided"), std::string::npos) << text;
}

TEST(Expectations, RefuseNormsThatDoNotFit)
{
  EXPECT_NE(error_of(head + check +
                     "take = {run = \"mpm_pf\", outline = \"o\"}\nagainst = \"zero\"\nnorm = "
                     "\"max\"\nlimit = 1\n")
                .find("outlines"),
            std::string::npos);
  EXPECT_NE(error_of(head + check +
                     "take = {run = \"mpm_pf\", number = \"n\"}\nnorm = \"relative\"\nlimit = 1\n")
                .find("against"),
            std::string::npos);
}

TEST(Expectations, NameTheMirrorsThatThereAre)
{
  const auto told = [](const std::string &take)
  {
    return error_of(head + check + "take = {run = \"mpm_pf\", " + take +
                    "}\nagainst = \"zero\"\nnorm = \"absolute\"\nlimit = 1\n");
  };
  EXPECT_EQ(told("outline = \"o\", of = \"area\", mirror = \"x\""), "");
  EXPECT_NE(told("outline = \"o\", of = \"area\", mirror = \"xy\"").find("no such mirror: `xy`"),
            std::string::npos);
  EXPECT_NE(told("number = \"n\", mirror = \"x\"").find("only an outline"), std::string::npos);
}

// Said when the file is read, not after the runs.
TEST(Expectations, NameTheQuantitiesAndSidesOfAnOutline)
{
  const auto told = [](const std::string &take)
  {
    return error_of(head + check + "take = {run = \"mpm_pf\", outline = \"o\", " + take +
                    "}\nagainst = \"zero\"\nnorm = \"absolute\"\nlimit = 1\n");
  };
  for (const char *known : {"area", "perimeter", "reach", "extreme_x\", side = \"left"})
    EXPECT_EQ(told("of = \"" + std::string(known) + "\""), "");
  EXPECT_NE(told("of = \"aera\"").find("an outline has no `aera`"), std::string::npos);
  EXPECT_NE(told("of = \"extreme_z\", side = \"left\"").find("an outline has no"),
            std::string::npos);
  EXPECT_NE(told("of = \"side\", side = \"lefft\", y = 1").find("no such side: `lefft`"),
            std::string::npos);
}

TEST(Expectations, RefuseAScaleOfZero)
{
  const std::string take = "take = {run = \"mpm_pf\", number = \"n\"}\nagainst = \"zero\"\nnorm = "
                           "\"absolute\"\nlimit = 1\n",
                    constants = "title = \"t\"\n[constants]\na = 2\n";
  const std::string run = "[[run]]\nsolver = \"mpm_pf\"\n";
  EXPECT_EQ(error_of(constants + run + check + take + "scale = \"a\"\n"), "");
  EXPECT_NE(error_of(constants + run + check + take + "scale = \"a - 2\"\n").find("is zero"),
            std::string::npos);
}

TEST(Expectations, RefuseNormsOfNumbersForCurvesAndIntegralsOfSnapshots)
{
  const std::string table = "take = {run = \"mpm_pf\", table = \"t\", of = \"u\"",
                    zero = "against = \"zero\"\n";
  for (const char *norm : {"relative", "absolute"})
  {
    const std::string limit = "norm = \"" + std::string(norm) + "\"\nlimit = 1\n";
    EXPECT_NE(error_of(head + check + table + "}\n" + zero + limit).find("a curve"),
              std::string::npos);
    EXPECT_EQ(error_of(head + check + table + ", at = 1}\n" + zero + limit), "");
    EXPECT_EQ(error_of(head + check + table + ", reduce = \"max\"}\n" + zero + limit), "");
  }
  const auto reduced = [](const std::string &how)
  {
    return error_of(head + check +
                    "take = {run = \"mpm_pf\", snapshot = \"s\", of = \"u\", reduce = \"" + how +
                    "\"}\nagainst = \"zero\"\nnorm = \"absolute\"\nlimit = 1\n");
  };
  for (const char *how : {"integral", "slope", "ripple"})
    EXPECT_NE(reduced(how).find("no abscissa"), std::string::npos) << how;
  EXPECT_EQ(reduced("max"), "");
}

TEST(Expectations, ResolveTablesBySuiteAndConstants)
{
  const Workspace w;
  w.write("cases/bar/scene.toml", "title = \"bar\"\n");
  w.write("cases/bar/expect.toml",
          "title = \"t\"\n[constants]\na = 2\nb = \"a^2\"\n[[run]]\nsolver = \"mpm_pf\"\nh = "
          "{quick = 0.5, full = 0.25}\n" +
              check +
              "take = {run = \"mpm_pf\", number = \"n\"}\nagainst = {number = \"b\"}\nnorm = "
              "\"relative\"\nlimit = {quick = \"a/100\", full = 0.01}\n");
  const Case quick = read_case(w.folder(), "quick"), full = read_case(w.folder(), "full");
  EXPECT_EQ(quick.constants.back().second, 4.);
  EXPECT_EQ(*quick.runs[0].h, 0.5);
  EXPECT_EQ(*full.runs[0].h, 0.25);
  EXPECT_EQ(quick.checks[0].high, 0.02);
  EXPECT_EQ(full.checks[0].high, 0.01);
  EXPECT_EQ(full.runs[0].scene, "scene.toml");
}

TEST(Expectations, NeedAMeshSizeForAnOrder)
{
  const std::string text =
      error_of(head + "[[run]]\nname = \"b\"\nsolver = \"mpm_pf\"\nh = 1\n" + check +
               "order_over = [\"mpm_pf\", \"b\"]\ntake = {line = \"l\", of = \"u\"}\nagainst = "
               "\"zero\"\nnorm = \"l2\"\nlimit = [1, 3]\n");
  EXPECT_NE(text.find("mesh size"), std::string::npos) << text;
}

TEST(Expectations, ExamineFormulasBeforeAnythingRuns)
{
  const std::string number = "take = {run = \"mpm_pf\", number = \"n\"}\n";
  const auto told = [&](const std::string &rest, const std::string &part)
  {
    const std::string text = error_of(head + check + rest);
    EXPECT_NE(text.find(part), std::string::npos) << rest << part << "\n" << text;
    EXPECT_NE(text.find("expect.toml"), std::string::npos) << rest << text;
  };
  told(number + "against = {number = \"2*(3\"}\nnorm = \"relative\"\nlimit = 1\n", "2*(3");
  told(number + "against = {number = \"2*sigma\"}\nnorm = \"relative\"\nlimit = 1\n",
       "no such name: `sigma`");
  told(number + "against = {number = 1}\nnorm = \"relative\"\nlimit = \"tolerance\"\n",
       "tolerance");
  told("take = {value = \"a/b\", with = {a = {run = \"mpm_pf\", number = \"n\"}}}\nnorm = "
       "\"value\"\nlimit = [0, 1]\n",
       "no such name: `b`");
  told("take = {run = \"mpm_pf\", table = \"t\", of = \"u +* v\", reduce = \"max\"}\nagainst = "
       "\"zero\"\nnorm = \"absolute\"\nlimit = 1\n",
       "u +* v");
  // Columns are known only when the record is.
  EXPECT_EQ(error_of(head + check +
                     "take = {run = \"mpm_pf\", table = \"t\", of = \"u + v\", reduce = "
                     "\"max\"}\nagainst = \"zero\"\nnorm = \"absolute\"\nlimit = 1\n"),
            "");
}
