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

  /// What is said of the file when the quick suite is read; "" if nothing.
  std::string said_of(const Workspace &w, const std::string &expect)
  {
    w.write("cases/bar/expect.toml", expect);
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

  std::string said_of(const std::string &expect)
  {
    return said_of(Workspace(), expect);
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

TEST(Expressions, ThatAssignOrListAreRefusedAsInScenes)
{
  expect_said(said_of(of_number(number, "limit = \"0,02\"")), "a list of 2 values");
  expect_said(said_of(of_number("run = \"mpm_pf\", table = \"t\", of = \"u = -2\", at = 1")),
              "assigns");
  EXPECT_EQ(said_of(of_number("run = \"mpm_pf\", table = \"t\", of = \"u == 2 ? 1 : 0\", at = 1")),
            "");
  EXPECT_THROW(evaluate("u, 3", {}, {{"u", {1., 2.}}}), BadInput);
}
