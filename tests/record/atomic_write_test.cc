// A text file is whole or not there, whatever the disk says.
#include <cerrno>
#include <filesystem>

#include <gtest/gtest.h>

#include "../scratch.h"
#include "record/atomic_write.h"

namespace fs = std::filesystem;

TEST(WholeFile, ReplacesAnOlderOneAndLeavesNothingElse)
{
  const Scratch scratch;
  record::write_atomically(scratch / "a.json", "old");
  record::write_atomically(scratch / "a.json", "new\n");
  EXPECT_EQ(scratch.read("a.json"), "new\n");
  EXPECT_FALSE(fs::exists(scratch / "a.json.part"));
}

TEST(WholeFile, KeepsTheOlderOneWhereTheDiskIsFull)
{
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full here";
  const Scratch scratch;
  record::write_atomically(scratch / "a.json", "old");
  fs::create_symlink("/dev/full", scratch / "a.json.part"); // every write to it fails
  try
  {
    record::write_atomically(scratch / "a.json", "new");
    FAIL() << "a full disk was not noticed";
  }
  catch (const fs::filesystem_error &error)
  {
    EXPECT_EQ(error.code().value(), ENOSPC) << error.what();
    EXPECT_EQ(error.path1(), scratch / "a.json");
  }
  EXPECT_EQ(scratch.read("a.json"), "old");
  EXPECT_FALSE(fs::exists(fs::symlink_status(scratch / "a.json.part")));
}

TEST(WholeFile, SaysThatTheFolderIsMissing)
{
  const Scratch scratch;
  EXPECT_THROW(record::write_atomically(scratch / "nowhere/a", "text"), fs::filesystem_error);
}
