// The bodies and what they are made of. The union of all bodies is the solid, the first phase field
// and the finite-element mesh alike (geometry.h); a body may reach over a symmetry side of the
// domain, where it is cut.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/domain.h"

namespace scene
{
  struct Rectangle
  {
    Point corner, size;
  };
  struct Disc
  {
    Point centre;
    double radius;
  };
  struct Ring
  {
    Point centre;
    double inner_radius, outer_radius;
  };
  struct Polygon
  {
    std::vector<Polyline> outlines;
  }; // even-odd rule: outer boundaries and holes alike
  /// The outline probe of an earlier record; record/outline_source.h replaces it by a Polygon.
  struct RecordedOutline
  {
    std::string path, probe;
    double time = -1.;                          // negative: the last one recorded
    std::optional<double> cut_above, cut_below; // keep only y < cut_above, y > cut_below
  };

  struct Body
  {
    std::string name;
    std::variant<Rectangle, Disc, Ring, Polygon, RecordedOutline> shape;
    VectorExpression velocity;                               // initial, of X, Y
    std::optional<std::array<Expression, 4>> initial_stress; // xx, yy, zz, xy, of X, Y
    SourceLocation place;
  };

  /// Elasto-viscoplastic solid. No yield stress: elastic. Yield stress without viscosity:
  /// rate-independent.
  struct Solid
  {
    double young_modulus = 0., poisson_ratio = 0., density = 0.;
    std::optional<double> yield_stress, viscosity;
    SourceLocation place;

    /// Deforms at nearly constant volume, so that full integration would be too stiff.
    bool locks() const { return yield_stress || poisson_ratio > 0.45; }
  };
} // namespace scene
