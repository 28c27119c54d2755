// Scenes from text and a folder of their own, removed after the test.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "medium/trouble.h"
#include "scene/reader.h"

namespace simulated
{
  class Folder
  {
  public:
    Folder()
    {
      const auto *test = ::testing::UnitTest::GetInstance()->current_test_info();
      static int number = 0;
      path = std::filesystem::temp_directory_path() /
             (std::string(test->test_suite_name()) + "." + test->name() + "." +
              std::to_string(getpid()) + "." + std::to_string(number++));
      std::filesystem::create_directories(path);
    }
    ~Folder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;
    std::string operator/(const std::string &name) const { return (path / name).string(); }

  private:
    std::filesystem::path path;
  };

  /// What the melt's numbers complain of during a call; "" if of nothing.
  template <class Call>
  std::string trouble_of(const Call &call)
  {
    try
    {
      call();
    }
    catch (const medium::NumericalTrouble &trouble)
    {
      return trouble.what();
    }
    return "";
  }

  inline scene::Scene scene_of(const Folder &folder, const std::string &text)
  {
    std::ofstream(folder / "scene.toml") << text;
    return scene::read_scene(folder / "scene.toml", {});
  }
} // namespace simulated
