// accuracy = "draft" | "standard" | "fine": settings chosen from measured fronts of error against
// cost, for whoever wants an error class and no list of knobs.
//
// A preset only speaks where the scene is silent: a key that is written keeps its value, and a
// module that is absent gets none. The resolution follows what must be resolved: the width of the
// interface where a crystal grows or a marker moves, else the thinnest body. The values and the
// errors they were measured to give stand in the README's table, which `verify presets` writes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/error_list.h"
#include "scene/scene.h"
#include "scene/value.h"

namespace scene
{
  /// Writes the preset's keys into the tree where they are not written, each with the place of
  /// `accuracy`; does nothing without it. An error where no mesh can be chosen.
  void apply_preset(Value &root, ErrorList &);

  /// One line per choice, and which of them the scene's own word overrides, for the banner and the
  /// plan; "" without a preset.
  std::string describe_preset(const Scene &);

  /// Cells of the given domain that are square and at most `spacing` wide (by at most a half
  /// finer); {0, 0} if none divide both sides. `marks`: distances from the domain's lower corner,
  /// by axis. The coarsest cells that have mesh lines on all of them are taken, else the coarsest.
  std::array<int, 2> square_cells(const Point &size, double spacing,
                                  const std::array<std::vector<double>, 2> &marks = {});
} // namespace scene
