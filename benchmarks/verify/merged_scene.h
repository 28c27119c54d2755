// The settings of a run as its solver will read them: scene, includes, --set and preset merged.
#pragma once

#include <string>

#include "expect.h"
#include "scene/value.h"

namespace verify
{
  struct MergedScene
  {
    scene::Value root;

    /// The value of a key ("mpm.mach", "wall.top.speed", "body.1.corner") as TOML text: what is
    /// written, else the default, else `absent`.
    std::string value(const std::string &key) const;
  };

  /// Errors of the scene are not reported here: the solver has reported them.
  MergedScene merged_scene(const Case &, const Run &);
} // namespace verify
