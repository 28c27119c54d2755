// Scenes that break one rule each: exactly one error may come, with file, line and reason.
#pragma once

#include "scene_file.h"

namespace scene_test
{
  struct Broken
  {
    std::string name;
    std::string text;   // of the scene
    std::string marked; // first words of the line that must be named
    std::string said;   // part of the error
  };

  inline void PrintTo(const Broken &broken, std::ostream *out)
  {
    *out << broken.name;
  }

  inline std::string plus(const std::string &text, const std::string &more)
  {
    return text + more;
  }

  inline void expect_refused(const Broken &broken)
  {
    const Folder folder;
    const std::string path = folder.write("broken.toml", broken.text);
    const std::string said = errors(path);
    EXPECT_EQ(count(said, "[error]"), 1) << said;
    EXPECT_NE(said.find(broken.said), std::string::npos) << said;
    int line = broken.marked.empty() ? 1 : line_of(broken.text, broken.marked);
    // Of two keys that exclude each other, and of doubled sections, the second is marked.
    if (broken.name == "two_walls_on_a_side")
      line += 2;
    else if (broken.name == "step_twice")
      line += 1;
    EXPECT_NE(said.find(path + ":" + std::to_string(line) + ": "), std::string::npos)
        << "line " << line << " expected\n"
        << said;
  }

  inline std::string name_of(const testing::TestParamInfo<Broken> &info)
  {
    return info.param.name;
  }
} // namespace scene_test
