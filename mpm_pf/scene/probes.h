// What is observed: both solvers answer the same named probes, so comparing them is comparing
// tables.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/domain.h"

namespace scene
{
  enum class Frame
  {
    current,
    material
  };

  struct LineProbe
  {
    Point a, b;
    int points;
    Frame frame = Frame::current;
    std::optional<double> bin;
  };
  struct PointProbe
  {
    Point at;
    Frame frame = Frame::material;
    std::optional<double> bin = {};
  };
  /// Volume mean over all material, or that which started in a box.
  struct RegionProbe
  {
    std::optional<Box> box;
  };
  struct ReactionProbe
  {
    std::string support;
  }; // columns force_x, force_y, displacement_x, displacement_y
  /// Closed polylines: the material outline, or the phi = 0 contour.
  struct OutlineProbe
  {
    enum class Of
    {
      material,
      phase
    } of = Of::material;
  };
  struct SnapshotProbe
  {
  };
  /// Dendrite tip along a ray from `origin` in `direction`: position, velocity, radius.
  struct TipProbe
  {
    Point origin, direction;
  };
  /// Scalar diagnostics of the whole run (energies, momentum, solid area, heat, mass); columns
  /// depend on modules.
  struct HistoryProbe
  {
  };

  struct Probe
  {
    std::string name;
    std::variant<LineProbe, PointProbe, RegionProbe, ReactionProbe, OutlineProbe, SnapshotProbe,
                 TipProbe, HistoryProbe>
        kind;
    std::vector<std::string> of;      // quantities; names in quantities.h
    std::vector<double> times;        // explicit times, or
    std::optional<double> every;      // an interval; neither: the end time only (line, outline,
                                      // snapshot), 200 samples (others)
    std::vector<double> compressions; // of a coupled scene with walls: at these relative
                                      // compressions instead (0 is first contact)
    SourceLocation place;
  };
} // namespace scene
