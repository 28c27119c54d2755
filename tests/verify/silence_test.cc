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

TEST(Campaign, DrawsFieldsThatHaveDiedAway)
{
  const Workspace w;
  const Campaign campaign =
      w.run(runs("") + check("table = \"history\", of = \"force*1e-300*1e-10\"",
                             "{formula = \"sin(x)*1e-300*2e-10\"}", "max"));
  EXPECT_EQ(campaign.exit_code, 0) << only(campaign).why;
}
