// How a support moves: the displacement of material that started at X, and the way back.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "scene/expression.h"

namespace solid
{
  using scene::Point;

  /// Straight motion given from outside, as that of a wall: displacement + velocity (t - since).
  struct Driven
  {
    Point displacement = Point::Zero(), velocity = Point::Zero();
    double since = 0.;
    std::array<bool, 2> holds{true, true};
  };

  /// Prescribed displacement; an empty component is free.
  struct Motion
  {
    std::array<std::optional<scene::Function>, 2> displacement;
    bool uniform = true;          // depends on time only
    std::optional<Driven> driven; // instead of the two

    bool holds(const int component) const
    {
      return driven ? driven->holds[component] : displacement[component].has_value();
    }
    /// Free components are 0.
    Point at(const Point &X, const Point &x, double t) const;

    /// Deformation gradient I + du/dX by central differences of step `h`; exact for affine motions.
    Eigen::Matrix2d gradient(const Point &X, const Point &x, double t, double h) const;

    /// Where the material now at `x` started, were it moved by the support alone: X + u(X, t) = x
    /// to 1e-9 `dx`. Throws medium::NumericalError if there is no such place near.
    Point origin(const Point &x, double t, double dx) const;
  };
} // namespace solid
