// What the functions share that make supports from a scene.
#pragma once

#include <string>

#include "scene/geometry.h"
#include "scene/reader.h"
#include "solid/supports.h"

namespace solid
{
  /// Stops with the support's place in the scene.
  [[noreturn]] inline void refuse(const scene::Support &support, const std::string &cause)
  {
    throw scene::BadScene(support.place.file + ":" + std::to_string(support.place.line) +
                          ": support \"" + support.name + "\" " + cause);
  }

  struct SupportBuilder
  {
    const scene::Scene &scene;
    Points &points;
    Tracers &tracers;
    Supports &supports;
    scene::Box box;
    double dx;
    int regions = 0, edges = 0;

    bool material(const Point &x) const
    {
      return scene::signed_distance(scene.bodies, x) > -1e-9 * dx;
    }
    double small() const { return place_tolerance(box, dx); }
  };

  /// Cells beyond one end of a line in which nodes are held: up to half-way to the first material
  /// there that a gap parts from what the line holds.
  double reach_beyond(const SupportBuilder &, const HeldLine &, int end);

  /// Hold what the support says of the outline, or a box of material; `index`: of the support.
  void hold_edge(SupportBuilder &, const scene::Support &, int index);
  void hold_box(SupportBuilder &, const scene::Support &, int index);
} // namespace solid
