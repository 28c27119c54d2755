// From a TOML file (with `include` and overrides) to a Scene; all errors in one pass.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace scene
{
  /// Bad input: one message per error, each with file, line, underlined text, cause and remedy.
  /// Exit code 2.
  struct BadScene : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /// Read `path`, follow `include`, apply `overrides` ("mpm.points_per_cell=[3,3]"), check every
  /// key and rule. Throws BadScene with all errors found, never only the first.
  Scene read_scene(const std::string &path, const std::vector<std::string> &overrides = {});

  /// Manual entry of one key ("mpm.mach"), of all keys of a section ("mpm"), of a function of an
  /// expression ("ramp"), of a quantity of a probe ("von_mises") or of everything (""), as text.
  /// Throws BadScene with the nearest known keys if there is none.
  std::string explain(const std::string &key);

  /// The manual page of the scene language, as Markdown, from the same tables.
  std::string manual();
} // namespace scene
