// Scenes written to a fresh folder for one test, and what is said about them.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../scratch.h"
#include "scene/reader.h"

namespace scene_test
{
  using Folder = Scratch;

  /// All that read_scene complains of; "" if it accepts the scene.
  inline std::string errors(const std::string &path, const std::vector<std::string> &overrides = {})
  {
    try
    {
      scene::read_scene(path, overrides);
    }
    catch (const scene::BadScene &error)
    {
      return error.what();
    }
    return "";
  }

  inline int count(const std::string &text, const std::string &word)
  {
    int n = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size())
      ++n;
    return n;
  }

  /// The line (from 1) on which `word` first stands in `text`.
  inline int line_of(const std::string &text, const std::string &word)
  {
    return 1 + count(text.substr(0, text.find(word)), "\n");
  }

  // A bar pulled at both ends: the smallest whole mechanics scene.
  inline const std::string bar = R"(title = "bar"
[domain]
size = [5.0, 2.4]
cells = [50, 24]
[[body]]
shape = "rectangle"
corner = [2.0, 0.2]
size = [1.0, 2.0]
[solid]
young_modulus = 2e11
poisson_ratio = 0.3
density = 7800
yield_stress = 4e8
[[support]]
on = "top"
displacement = ["0.4*t", 0]
[[support]]
on = "bottom"
displacement = ["-0.4*t", "free"]
[[probe]]
name = "line"
line = [[1.5, 1.2], [3.5, 1.2]]
points = 101
of = ["von_mises", "plastic_strain"]
[[probe]]
name = "force"
reaction = "top"
[clock]
end = 1.0
[mpm]
mach = 2e-3
)";

  // A seed in a corner of a quarter domain: the smallest whole growth scene.
  inline const std::string seed = R"(title = "seed"
[units]
system = "W0-tau0-sigmaY"
[domain]
size = [40.0, 40.0]
cells = [100, 100]
boundary = "symmetry"
[[body]]
shape = "disc"
centre = [0.0, 0.0]
radius = 8.0
[phase_field]
width = 1.0
[growth]
anisotropy = 0.05
[heat]
diffusivity = 3.0
undercooling = 0.55
[[probe]]
name = "tip"
tip = {origin = [0.0, 0.0], direction = [1.0, 0.0]}
[clock]
end = 10.0
)";

  /// `text` with the first `from` replaced by `to`; fails the test if there is none.
  inline std::string with(std::string text, const std::string &from, const std::string &to)
  {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "no \"" << from << "\" in the scene";
    if (at != std::string::npos)
      text.replace(at, from.size(), to);
    return text;
  }
} // namespace scene_test
