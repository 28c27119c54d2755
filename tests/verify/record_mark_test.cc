// A record is reused and judged only while it is the one that its run left, of the scene as it is.
#include <cstdlib>

#include <gtest/gtest.h>

#include "measure.h"
#include "workspace.h"

using namespace verify;

namespace
{
  const std::string two_runs = R"toml([[run]]
solver = "mpm_pf"
[[run]]
name   = "wrong"
solver = "mpm_pf"
set    = ["fake.error=0.5"]
[[check]]
name   = "force"
take   = {run = "mpm_pf", table = "history", of = "force", at = 0.5}
against = {number = "2*sin(0.5)"}
norm   = "relative"
limit  = 1e-6
source = "s"
reason = "r"
)toml";
  const std::string scene_until = R"(title = "bar"
[domain]
size = [1.0, 1.0]
cells = [10, 10]
[[body]]
shape = "rectangle"
corner = [0.2, 0.2]
size = [0.5, 0.5]
[solid]
young_modulus = 1.0
poisson_ratio = 0.3
density = 1.0
[clock]
end = )";
  const char *const one_run = "[[run]]\nsolver = \"mpm_pf\"\n";

  void replace_record(const Workspace &w)
  {
    const auto folder = w.root / "results/bar/quick";
    std::filesystem::copy_file(folder / "wrong.h5", folder / "mpm_pf.h5",
                               std::filesystem::copy_options::overwrite_existing);
  }
} // namespace

TEST(RecordMark, ARecordCopiedOverAnotherIsNotReused)
{
  const Workspace w;
  ASSERT_EQ(w.run(two_runs).exit_code, 0);
  replace_record(w);
  const auto again = w.run(two_runs);
  EXPECT_FALSE(again.cases[0].outcomes[0].reused);
  EXPECT_TRUE(again.cases[0].outcomes[1].reused);
  EXPECT_EQ(again.exit_code, 0) << again.cases[0].verdicts[0].why;
}

TEST(RecordMark, ARecordCopiedOverAnotherIsNotJudged)
{
  const Workspace w;
  ASSERT_EQ(w.run(two_runs).exit_code, 0);
  const std::string folder = (w.root / "results/bar/quick").string();
  EXPECT_NO_THROW(Records(folder, {}).open("mpm_pf"));
  replace_record(w);
  try
  {
    Records(folder, {}).open("mpm_pf");
    FAIL() << "it was opened";
  }
  catch (const MissingData &error)
  {
    EXPECT_NE(std::string(error.what()).find("is not the one that the run left"), std::string::npos)
        << error.what();
  }
}

TEST(RecordMark, ABrokenRecordIsMadeAgain)
{
  const Workspace w;
  ASSERT_EQ(w.run(two_runs).exit_code, 0);
  w.write("results/bar/quick/mpm_pf.h5", "no HDF5");
  const auto again = w.run(two_runs);
  EXPECT_FALSE(again.cases[0].outcomes[0].reused);
  EXPECT_EQ(again.exit_code, 0);
}

TEST(RecordMark, ARecordOfAnotherSceneIsRefusedAndMadeAgain)
{
  const Workspace w;
  w.write("cases/bar/quick.toml", scene_until + "1.0\n");
  w.write("other.toml", scene_until + "2.0\n");
  setenv("FAKE_SCENE", (w.root / "other.toml").c_str(), 1);
  const auto other = w.run(one_run);
  unsetenv("FAKE_SCENE");
  EXPECT_EQ(other.cases[0].outcomes[0].status, "failed");
  EXPECT_NE(other.cases[0].outcomes[0].log_tail.find("another scene"), std::string::npos);
  EXPECT_EQ(other.exit_code, 1);
  const auto own = w.run(one_run);
  EXPECT_FALSE(own.cases[0].outcomes[0].reused);
  EXPECT_EQ(own.cases[0].outcomes[0].status, "complete");
  EXPECT_TRUE(w.run(one_run).cases[0].outcomes[0].reused);
}
