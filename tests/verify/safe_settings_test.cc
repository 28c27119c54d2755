// What a run that diverged learns from the map of its case.
#include <gtest/gtest.h>

#include "safe_settings.h"
#include "workspace.h"

using namespace verify;

namespace
{
  /// A map as `verify stability` writes it: with few points a step of 0.3 is bounded, with many one
  /// of 1 accurate.
  const char *const known = R"json({"maps": [{
  "name": "step and points",
  "x": {"label": "step", "values": ["0.1", "1.0", "10.0"], "set": ["mpm.step_fraction={value}"], "logarithmic": true},
  "y": {"label": "points", "values": ["[1, 1]", "[3, 3]"], "set": ["mpm.points_per_cell=[{0},{1}]"], "logarithmic": false},
  "cells": [
    {"column": 0, "row": 0, "x": "0.1", "y": "[1, 1]", "class": "bounded but wrong"},
    {"column": 1, "row": 0, "x": "1.0", "y": "[1, 1]", "class": "diverged"},
    {"column": 2, "row": 0, "x": "10.0", "y": "[1, 1]", "class": "diverged"},
    {"column": 0, "row": 1, "x": "0.1", "y": "[3, 3]", "class": "accurate"},
    {"column": 1, "row": 1, "x": "1.0", "y": "[3, 3]", "class": "accurate"},
    {"column": 2, "row": 1, "x": "10.0", "y": "[3, 3]", "class": "diverged"}],
  "bisected": [{"row": 0, "x": "0.3", "y": "[1, 1]", "class": "bounded but wrong"}],
  "edges": []}]})json";

  /// The advice to a run that diverged, by the map of `folder`.
  std::string advice(const std::string &scene, const std::string &set,
                     const std::string &folder = "results")
  {
    const Workspace w;
    w.write("cases/bar/quick.toml", "title = \"bar\"\n" + scene);
    w.write(folder + "/stability/bar.json", known);
    const auto campaign =
        w.run("[[run]]\nsolver = \"mpm_pf\"\nset = [\"fake.exit=3\"" + set + "]\n");
    return campaign.cases.at(0).outcomes.at(0).log_tail;
  }
  const std::string few = "step = 0.3 with points = [1, 1]",
                    many = "points = [3, 3] with step = 1.0";
} // namespace

TEST(SafeSetting, IsFoundFromTheSceneTheSettingsAndTheDefaults)
{
  // from the scene, whatever the settings say of other things; both axes
  const std::string scene = "[mpm]\nstep_fraction = 0.9\npoints_per_cell = [1, 1]\n";
  const std::string text = advice(scene, "");
  EXPECT_NE(text.find("known to be bounded but wrong: " + few), std::string::npos) << text;
  EXPECT_NE(text.find("known to be accurate: " + many), std::string::npos) << text;
  EXPECT_EQ(advice(scene, "", "elsewhere/full").find("known"), std::string::npos);
  // what --set says comes last
  const std::string other = advice(scene, ", \"mpm.step_fraction=8.0\"");
  EXPECT_NE(other.find(few), std::string::npos) << other;
  EXPECT_EQ(other.find("known to be accurate"), std::string::npos) << "none in this column";
  // points_per_cell = [2, 2] is the default: as near to both rows, so the first
  const std::string standard = advice("[mpm]\nstep_fraction = 0.9\n", "");
  EXPECT_NE(standard.find(few), std::string::npos) << standard;
}

TEST(SafeSetting, StaysInTheRowOfTheRun)
{
  // 7 is nearest to the column of 10; in the row of 3 x 3 points 1 is safe, and no other row counts
  const std::string text = advice("[mpm]\nstep_fraction = 7.0\npoints_per_cell = [3, 3]\n", "");
  EXPECT_NE(text.find("known to be accurate: step = 1.0 with points = [3, 3]"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("[1, 1]"), std::string::npos) << text;
}

// The map calls it accurate, and yet it diverged: of another setting, which the map does not vary.
TEST(SafeSetting, IsNothingWhereTheMapFindsNoFault)
{
  const std::string scene = "[mpm]\nstep_fraction = 1.0\npoints_per_cell = [3, 3]\n";
  EXPECT_EQ(advice(scene, "").find("known"), std::string::npos);
  EXPECT_NE(advice(scene, ", \"mpm.step_fraction=1.1\"").find("known"), std::string::npos);
}

TEST(SafeSetting, IsAlsoThatOfTheFullMapsBesideTheFolder)
{
  const Workspace w;
  w.write("cases/bar/quick.toml", "title = \"bar\"\n[mpm]\nstep_fraction = 0.9\n");
  w.write("full/stability/bar.json", known);
  const Case c = [&]
  {
    w.write("cases/bar/expect.toml", "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n");
    return read_case(w.folder(), "quick");
  }();
  const std::string text = nearest_safe_setting(w.options().output, c, c.runs.at(0));
  EXPECT_NE(text.find(few), std::string::npos) << text;
  EXPECT_NE(text.find("full/stability/bar.json"), std::string::npos) << text;
}

TEST(SafeSetting, IsNothingWhereTheMapVariesWhatTheRunDoesNotHave)
{
  EXPECT_EQ(
      advice("[mpm]\nstep_fraction = 0.9\npoints_per_cell = [[1, 1], [1, 1]]\n", "").find("known"),
      std::string::npos);
}
