// A folder of its own for each test, removed after it: nothing of ours stays in the temporary
// folder.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

class Scratch
{
public:
  Scratch()
  {
    static int number = 0; // a test may have several
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name() + "." +
                       std::to_string(getpid()) + "." + std::to_string(number++);
    std::replace(name.begin(), name.end(), '/', '.'); // of a test with parameters
    folder = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(folder);
  }
  ~Scratch()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  Scratch(const Scratch &) = delete;
  Scratch &operator=(const Scratch &) = delete;
  std::string operator/(const std::string &name) const { return (folder / name).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string &name, const std::string &text) const
  {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }
  std::string read(const std::string &name) const
  {
    std::ifstream file(folder / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

private:
  std::filesystem::path folder;
};

/// What a call threw, "" if nothing; so that a test can look for the words of an error.
template <class Exception, class Call>
std::string error_of(const Call &call)
{
  try
  {
    call();
  }
  catch (const Exception &error)
  {
    return error.what();
  }
  return "";
}
