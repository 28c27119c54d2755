// A disk that fills up: said with the file's name, whatever had a final name keeps it, and the
// program ends as it wants to.
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include <sys/resource.h>

#include "record/checkpoint.h"
#include "record/reader.h"
#include "record/writer.h"
#include "../scratch.h"

namespace
{
  using namespace record;

  /// No file of this process grows beyond it from now on; "File too large" stands for "disk full".
  void fill_the_disk_beyond(const rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  void record_rows(Writer &writer, const int count)
  {
    for (int k = 0; k < count; ++k)
      writer.table("energy", {{"kinetic"}, {"J"}}, k, {0.5 * k});
  }

  /// Runs in a process of its own: the exit of a program whose HDF5 failed is part of the test.
  template <class Call>
  [[noreturn]] void say_and_exit(const rlim_t room, const Call &call)
  {
    fill_the_disk_beyond(room);
    const std::string said = error_of<std::runtime_error>(call);
    fill_the_disk_beyond(RLIM_INFINITY); // what is said here goes into a file, too
    std::cerr << said << std::endl;
    fill_the_disk_beyond(room);
    std::exit(7);
  }

  void put_all(const std::string &path, const std::size_t size)
  {
    CheckpointFile checkpoint(path, {});
    checkpoint.put("steps", 3.);
    std::vector<float> values(size);
    for (std::size_t k = 0; k < size; ++k)
      values[k] = std::sin(float(k)); // which no filter makes small
    checkpoint.put("solid/x", values);
    checkpoint.finish();
  }

  std::string bytes_of(const std::string &path)
  {
    std::ostringstream all;
    all << std::ifstream(path, std::ios::binary).rdbuf();
    return all.str();
  }
} // namespace

TEST(FullDisk, ARecordThatCannotBeFinishedKeepsItsUnfinishedName)
{
  const Scratch scratch;
  const auto attempt = [&](const rlim_t room)
  {
    Writer writer(scratch / "run.h5", {}, {}, false);
    record_rows(writer, 10000);
    say_and_exit(room, [&] { writer.finish({}); });
  };
  for (const rlim_t room : {1024, 4096, 100000}) // bytes; all of it is 170000
    EXPECT_EXIT(attempt(room), testing::ExitedWithCode(7), "run.h5.part.*disk full\\?");
  EXPECT_FALSE(std::filesystem::exists(scratch / "run.h5"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "run.h5.part"));
}

TEST(FullDisk, NothingIsTriedAgainInARecordThatIsBroken)
{
  const Scratch scratch;
  const auto attempt = [&]
  {
    {
      Writer writer(scratch / "run.h5", {}, {}, false);
      record_rows(writer, 10000);
      fill_the_disk_beyond(4096);
      EXPECT_THROW(writer.flush(), std::runtime_error);
    }
    std::exit(7);
  };
  EXPECT_EXIT(attempt(), testing::ExitedWithCode(7), "");
  EXPECT_FALSE(std::filesystem::exists(scratch / "run.h5"));
}

TEST(FullDisk, ACheckpointThatCannotBeWrittenLeavesTheOneBefore)
{
  const Scratch scratch;
  const std::string path = scratch / "run.checkpoint.h5";
  put_all(path, 5000);
  const std::string before = bytes_of(path);
  const auto attempt = [&](const rlim_t room, const std::size_t size)
  { say_and_exit(room, [&] { put_all(path, size); }); };
  for (const rlim_t room : {1024, 4096})
    EXPECT_EXIT(attempt(room, 100), testing::ExitedWithCode(7),
                "run.checkpoint.h5.part.*disk full\\?");
  EXPECT_EXIT(attempt(30000, 1000000), testing::ExitedWithCode(7),
              "run.checkpoint.h5.part.*disk full\\?");
  EXPECT_TRUE(bytes_of(path) == before);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}
