// A folder of its own for each test, removed after it.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

class Scratch
{
public:
  Scratch()
  {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    folder =
        std::filesystem::temp_directory_path() / (std::string(test->test_suite_name()) + "." +
                                                  test->name() + "." + std::to_string(getpid()));
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
