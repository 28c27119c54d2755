// One writer at a time: who comes second is told who came first, and spoils nothing.
#include "record/lock.h"

#include <sys/wait.h>

#include "../scratch.h"
#include "record/reader.h"
#include "record/writer.h"

namespace
{
  using namespace record;

  std::string refusal(const std::string &path)
  {
    return error_of<std::runtime_error>([&] { const Lock lock(path, "the folder", "go away"); });
  }
} // namespace

TEST(Lock, IsTakenOnceAndNamesItsHolder)
{
  const Scratch scratch;
  const std::string path = scratch / "lock";
  {
    const Lock lock(path, "the folder", "go away");
    EXPECT_EQ(refusal(path),
              "the folder is in use by process " + std::to_string(getpid()) + ": go away");
    EXPECT_NE(refusal(path), "") << "the refused one has taken the file away";
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(refusal(path), "");
}

TEST(Lock, OfAKilledProcessBarsNobody)
{
  const Scratch scratch;
  const std::string path = scratch / "lock";
  const pid_t child = fork();
  if (child == 0)
  {
    const Lock lock(path, "the folder", "go away");
    _exit(0); // as a kill: no destructor runs
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(refusal(path), "");
}

TEST(Lock, ThatCannotBeMadeSaysWhy)
{
  const Scratch scratch;
  EXPECT_NE(refusal(scratch / "absent/lock").find("No such file"), std::string::npos);
}

TEST(Lock, KeepsASecondWriterOutOfARecord)
{
  const Scratch scratch;
  const std::string path = scratch / "run.h5";
  scene::Scene scene;
  scene.hash = "1";
  Writer writer(path, {}, scene, false);
  writer.table("energy", {{"kinetic"}, {"J"}}, 0., {1.});
  writer.flush();
  const auto second = [&](const auto how)
  { return error_of<std::runtime_error>([&] { const Writer other(path, {}, scene, how); }); };
  const std::string by = "in use by process " + std::to_string(getpid());
  EXPECT_NE(second(true).find(by), std::string::npos) << "with --force";
  EXPECT_NE(second(Writer::Resume{0.}).find(by), std::string::npos) << "with --resume";
  writer.table("energy", {{"kinetic"}, {"J"}}, 1., {2.});
  writer.finish({});
  EXPECT_EQ(Reader(path).table("energy").time, (std::vector<double>{0., 1.}));
  EXPECT_EQ(second(true), "") << "the record is finished and its writer still there";
}
