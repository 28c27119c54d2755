// Scenes from text and a folder of their own, removed after the test.
#pragma once

#include <string>

#include "../scratch.h"
#include "medium/numerical_error.h"
#include "scene/reader.h"

namespace simulated
{
  using Folder = Scratch;

  /// What the melt's numbers complain of during a call; "" if of nothing.
  template <class Call>
  std::string trouble_of(const Call &call)
  {
    try
    {
      call();
    }
    catch (const medium::NumericalError &trouble)
    {
      return trouble.what();
    }
    return "";
  }

  inline scene::Scene scene_of(const Folder &folder, const std::string &text)
  {
    return scene::read_scene(folder.write("scene.toml", text), {});
  }
} // namespace simulated
