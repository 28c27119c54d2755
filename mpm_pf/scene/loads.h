// What holds, pulls and presses the bodies: supports, tractions, body force, walls.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "scene/domain.h"

namespace scene
{
  /// Which material is meant, by its initial position: the part of the outline on a side of the
  /// bodies' common bounding box, the part of the outline on a segment, or all material inside a
  /// box (a grip).
  using Where = std::variant<Edge, Segment, Box>;

  struct Support
  {
    std::string name; // default: the word after `on`
    Where where;
    std::array<std::optional<Expression>, 2> displacement; // empty: this component is free
    SourceLocation place;
  };

  struct Traction
  {
    std::string name;
    Where where;                        // a box: the part of the outline that starts in it
    VectorExpression traction;          // force per deformed length and unit depth
    std::optional<Expression> pressure; // instead: along the inward normal of the deformed outline
    SourceLocation place;
  };

  struct BodyForce
  {
    VectorExpression acceleration;
    SourceLocation place;
  };

  enum class WallGrip
  {
    grip,
    slip
  };
  struct Wall
  {
    Edge side;
    double speed = 0.;  // inward
    double travel = 0.; // total inward travel at which the wall stops
    // Gap to phi = 0 at which it starts; a scene that was read always has this (8 W0 where nothing
    // is written) or `start_time`.
    std::optional<double> start_distance;
    std::optional<double> start_time; // or the time at which it starts
    // Time over which the speed rises smoothly, and does so once more, from rest, from the first
    // contact on (0: it does not stop there). Absent: the program's choice.
    std::optional<double> ramp;
    std::optional<double> contact_ramp;
    WallGrip grip = WallGrip::grip;
    SourceLocation place;
  };
} // namespace scene
