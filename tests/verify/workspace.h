// A scratch folder with a case, a scene and the fake solver under both solvers' names.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "campaign.h"
#include "section.h"

/// Removed with all its contents when it goes out of scope.
struct Workspace
{
  std::filesystem::path root;

  Workspace()
  {
    static int number = 0;
    root = std::filesystem::temp_directory_path() /
           ("verify_test_" + std::to_string(getpid()) + "_" + std::to_string(number++));
    std::filesystem::create_directories(root / "cases" / "bar");
    std::filesystem::create_directories(root / "bin");
    for (const char *solver : {"mpm_pf", "fe_reference"})
      std::filesystem::create_symlink(FAKE_SOLVER, root / "bin" / solver);
    write("cases/bar/quick.toml", "title = \"bar\"\n");
  }
  ~Workspace() { std::filesystem::remove_all(root); }
  Workspace(const Workspace &) = delete;
  Workspace &operator=(const Workspace &) = delete;

  void write(const std::string &path, const std::string &text) const
  {
    std::filesystem::create_directories((root / path).parent_path());
    std::ofstream(root / path) << text;
  }
  std::string read(const std::string &path) const
  {
    std::stringstream text;
    text << std::ifstream(root / path).rdbuf();
    return text.str();
  }
  std::string folder() const { return (root / "cases" / "bar").string(); }

  /// What is said of this expect.toml as the quick suite reads it; "" if nothing.
  std::string said_of(const std::string &expect) const
  {
    write("cases/bar/expect.toml", expect);
    try
    {
      verify::read_case(folder(), "quick");
    }
    catch (const verify::BadInput &error)
    {
      return error.what();
    }
    return "";
  }

  verify::Paths paths() const
  {
    verify::Paths paths;
    paths.cases = (root / "cases").string();
    paths.solvers = (root / "bin").string();
    paths.postprocess = (root / "postprocess").string();
    paths.program = "verify";
    paths.asked = {"--cases", "elsewhere"};
    return paths;
  }

  verify::CampaignOptions options() const
  {
    verify::CampaignOptions options;
    options.suite = "quick";
    options.output = (root / "results").string();
    options.cores = 2;
    return options;
  }

  /// Writes expect.toml (title added) and runs the quick suite.
  verify::Campaign run(const std::string &expect) const
  {
    write("cases/bar/expect.toml", "title = \"bar\"\n" + expect);
    return verify::run_campaign(options(), paths());
  }
};
