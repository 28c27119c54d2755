// A scene from its text.
#pragma once

#include <string>
#include <vector>

#include "../scratch.h"
#include "scene/reader.h"

/// The reader takes files: this one is gone when the scene is there.
inline scene::Scene scene_of(const std::string &text)
{
  const Scratch scratch;
  return scene::read_scene(scratch.write("scene.toml", text), {});
}
