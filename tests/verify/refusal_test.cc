// What a check must not say: refused when its file is read, with the place.
#include <cmath>

#include <gtest/gtest.h>

#include "csv.h"
#include "section.h"
#include "stability_file.h"
#include "trade_file.h"
#include "workspace.h"

using namespace verify;

namespace
{
  const std::string runs =
      "title = \"t\"\n[constants]\na = 2\n[[run]]\nsolver = \"mpm_pf\"\nh = 1\n"
      "[[run]]\nname = \"b\"\nsolver = \"mpm_pf\"\nh = 2\n"
      "[[run]]\nname = \"c\"\nsolver = \"mpm_pf\"\nh = 4\n"
      "[[run]]\nname = \"d\"\nsolver = \"mpm_pf\"\nh = 4\n";

  std::string said_of(const std::string &expect)
  {
    return Workspace().said_of(expect);
  }

  std::string check(const std::string &keys)
  {
    return runs + "[[check]]\nname = \"c\"\nsource = \"s\"\nreason = \"r\"\n" + keys + "\n";
  }

  /// A check of one number against 1.
  std::string of_number(const std::string &take, const std::string &rest = "")
  {
    return check("take = {" + take + "}\nagainst = {number = 1}\nnorm = \"absolute\"\n" +
                 (rest.find("limit") == std::string::npos ? "limit = 1\n" : "") + rest);
  }
  const std::string number = "run = \"mpm_pf\", number = \"n\"",
                    maximum = "run = \"mpm_pf\", table = \"t\", of = \"u\", reduce = \"max\"";

  void expect_said(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_NE(text.find("expect.toml"), std::string::npos) << text;
  }
} // namespace

TEST(Patterns, ThatAreNoneAreRefused)
{
  const std::string run = "title = \"t\"\n[[run]]\nsolver = \"mpm_pf\"\nexpect_exit = 2\n";
  EXPECT_EQ(said_of(run + "expect_output = 'density\\('\n"), "");
  expect_said(said_of(run + "expect_output = 'density('\n"), "no regular expression");
}

TEST(ReferenceTables, AreExaminedBeforeAnythingRuns)
{
  const Workspace w;
  const auto told = [&](const std::string &table)
  {
    w.write("cases/bar/r.csv", table);
    return w.said_of(check("take = {run = \"mpm_pf\", table = \"t\", of = \"u\"}\nagainst = {csv = "
                           "\"r.csv\", of = \"u\"}\nnorm = \"max\"\nlimit = 1"));
  };
  EXPECT_EQ(told("# exact\ntime,u\n0,1e-310\n"), "");
  EXPECT_EQ(told("\xEF\xBB\xBFtime,u\n0,1\n"), "") << "a byte order mark";
  expect_said(told("time,u,u\n0,1,2\n"), "r.csv:1: two headings are `u`");
  expect_said(told("time,u,\"\"\n0,1,2\n"), "r.csv:1: the heading `` is no name");
  expect_said(told("time,u\n0,1\n1,one\n"), "r.csv:3: `one` is not a number");
  expect_said(told("time,v\n0,1\n"), "no column `u`");
}

TEST(Grids, OfAReferenceThatIsNoRunAreRefused)
{
  const std::string grids = "uncertainty = {against = [\"mpm_pf\", \"b\", \"c\"]}";
  expect_said(said_of(of_number(maximum, grids)), "held against no run");
}

TEST(Grids, OfOneMeshSizeAreRefused)
{
  const auto told = [](const std::string &grids)
  { return said_of(of_number(maximum, "uncertainty = {take = [" + grids + "]}")); };
  EXPECT_EQ(told("\"mpm_pf\", \"b\", \"c\""), "");
  expect_said(told("\"b\", \"b\", \"b\""), "run `b` is named twice");
  expect_said(told("\"b\", \"c\", \"d\""), "runs `c` and `d` both have h = 4");
}

TEST(MeshSizes, AreAboveZero)
{
  for (const char *h : {"0", "-1.0", "nan"})
    expect_said(
        said_of("title = \"t\"\n[[run]]\nsolver = \"mpm_pf\"\nh = " + std::string(h) + "\n"),
        "h = " + std::string(h));
}

TEST(Expressions, ThatAreEmptyAreRefused)
{
  expect_said(said_of(check("take = {" + number +
                            "}\nagainst = {number = \"\"}\nnorm = "
                            "\"relative\"\nlimit = 1")),
              "`number` holds an empty expression");
  expect_said(said_of(check("take = {run = \"mpm_pf\", line = \"l\", of = \"u\"}\nagainst = "
                            "{formula = \"\"}\nnorm = \"max\"\nlimit = 1")),
              "`formula` holds an empty expression");
}

TEST(Expressions, ThatAssignOrListAreRefusedAsInScenes)
{
  expect_said(said_of(of_number(number, "limit = \"0,02\"")), "a list of 2 values");
  expect_said(said_of(of_number("run = \"mpm_pf\", table = \"t\", of = \"u = -2\", at = 1")),
              "assigns");
  EXPECT_EQ(said_of(of_number("run = \"mpm_pf\", table = \"t\", of = \"u == 2 ? 1 : 0\", at = 1")),
            "");
  EXPECT_THROW(evaluate("u, 3", {}, {{"u", {1., 2.}}}), BadInput);
}

// The check named in each file is one that passes, whatever the run does.
TEST(Checks, ThatCannotFailAreRefused)
{
  const auto against_itself =
      [](const std::string &take, const std::string &against, const std::string &norm)
  {
    return said_of(check("take = {run = \"mpm_pf\", " + take + "}\nagainst = {run = \"mpm_pf\"" +
                         against + "}\nnorm = \"" + norm + "\"\nlimit = 1"));
  };
  const std::string itself = "held against itself", table = "table = \"t\", of = \"u\"";
  expect_said(against_itself(table, "", "max"), itself);
  expect_said(against_itself("outline = \"o\"", ", at = \"end\"", "hausdorff"), itself);
  EXPECT_EQ(against_itself("outline = \"o\"", ", at = 0", "hausdorff"), "");
  EXPECT_EQ(against_itself(table + ", reduce = \"last\"", ", reduce = \"first\"", "relative"), "");

  expect_said(said_of(of_number("run = \"mpm_pf\", table = \"t\", of = \"2*a\", at = 1")),
              "names no column");
  expect_said(said_of(of_number("value = \"1 + 1\"")), "whatever the run does");
  EXPECT_EQ(said_of(of_number("value = \"a/2\"")), "") << "this checks a constant";
  const std::string p = "p = {" + number + "}", q = "q = {" + number + "}";
  expect_said(said_of(of_number("value = \"p - q\", with = {" + p + ", " + q + "}")),
              "one and the same take");
  expect_said(said_of(of_number("value = \"a\", with = {" + p + "}")), "does not use `p`");
}

TEST(Numbers, ThatLetEverythingPassAreRefused)
{
  for (const char *key : {"scale = \"1/0\"", "limit = \"1/0\"", "coverage = 0", "coverage = -3",
                          "drift = nan", "drift = 1e9", "drift = -1"})
    expect_said(said_of(of_number(maximum, key)), key);
  EXPECT_EQ(said_of(of_number(maximum, "drift = 10\ncoverage = 1.0")), "");
}

TEST(Keys, ThatSayNothingAboutATakeAreRefused)
{
  const std::string table = "table = \"t\", of = \"u\", ", line = "line = \"l\", of = \"u\", ",
                    snapshot = "snapshot = \"s\", of = \"u\", reduce = \"min\", ",
                    area = "outline = \"o\", of = \"area\", ", last = "reduce = \"last\"";
  const struct
  {
    std::string take, said;
  } takes[] = {{table + "at = 1, " + last, "`at` beside `reduce`"},
               {table + "at = 1, nth = 2", "`nth` says nothing about a table"},
               {table + "at = 1, box = [[0, 0], [1, 1]]", "`box` says nothing"},
               {line + last + ", rotate = 90", "`rotate` says nothing"},
               {line + last + ", side = \"left\"", "`side` says nothing"},
               {line + last + ", at = 1, nth = 2", "both say which recording"},
               {line + last + ", nth = 1.5", "no recording"},
               {snapshot + "between = [0, 1]", "`between` says nothing about a snapshot"},
               {area + last, "`reduce` says nothing about an outline"},
               {area + "shift = [5]", "`shift` is [x, y]"},
               {area + "shift = [5, 6, 7]", "`shift` is [x, y]"},
               {area + "side = \"left\"", "`side` says nothing about of = \"area\""},
               {area + "y = 3", "`y` says nothing about of = \"area\""},
               {"outline = \"o\", of = \"side\", side = \"left\", x = 0.5", "and y, or"},
               {"number = \"n\", of = \"u\"", "`of` says nothing about a number"}};
  for (const auto &[take, said] : takes)
    expect_said(said_of(of_number("run = \"mpm_pf\", " + take)), said);
  // what is written takes the place of what would be inherited
  EXPECT_EQ(said_of(check("take = {run = \"mpm_pf\", table = \"t\", of = \"u\", at = 1}\nagainst = "
                          "{run = \"b\", reduce = \"max\"}\nnorm = \"relative\"\nlimit = 1")),
            "");
}

TEST(Suites, ThatACaseLacksAreNamed)
{
  EXPECT_EQ(said_of(of_number(number, "suites = [\"quick\", \"full\"]")), "");
  expect_said(said_of(of_number(number, "suites = [\"full\"]")), "takes part in none of full");
}

TEST(Norms, ThatAreMisspeltAreRefusedOfTradesAndMaps)
{
  const Workspace w;
  const std::string take = "take = {number = \"n\"}\nagainst = {number = 1}\n";
  const auto message = [](const auto &read) -> std::string
  {
    try
    {
      read();
    }
    catch (const BadInput &error)
    {
      return error.what();
    }
    return "";
  };
  w.write("cases/bar/tradeoff.toml", "[[quantity]]\nname = \"q\"\n" + take +
                                         "norms = [\"relative\", \"relativ\"]\n[[family]]\nname = "
                                         "\"f\"\n");
  const std::string trade = message([&] { read_trade(w.folder()); });
  EXPECT_NE(trade.find("no such norm: `relativ`"), std::string::npos) << trade;
  w.write("cases/bar/stability.toml",
          "[[accurate]]\n" + take + "norm = \"absolut\"\nlimit = 0.1\n");
  const std::string map = message([&] { read_stability(w.folder(), "quick"); });
  EXPECT_NE(map.find("no such norm: `absolut`"), std::string::npos) << map;
}
