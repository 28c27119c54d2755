// Where everything happens: the regular mesh of the domain, and the few words of the scene language
// that every other header of this room uses.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace scene
{
  /// A position or a vector in the plane, in the scene's length unit.
  using Point = Eigen::Vector2d;

  /// Where something was written, so that every later error can name it.
  struct SourceLocation
  {
    std::string file;
    int line = 0;
    std::string key;
  };

  /// An expression of X, Y (initial position), x, y (current position) and t, as written;
  /// expression.h compiles it.
  struct Expression
  {
    std::string text = "0";
    SourceLocation place;
  };
  using VectorExpression = std::array<Expression, 2>;

  /// Room for the widest stencil: cells that a mesh has each way at least, and that are left
  /// between walls.
  inline constexpr int fewest_cells = 3, cells_between_walls = 5;

  /// Unit system of all numbers in the file; it changes only how units are printed.
  enum class Units
  {
    si,
    w0_tau0_sigma_y
  };

  enum class Edge
  {
    left,
    right,
    bottom,
    top
  };

  struct Segment
  {
    Point a, b;
  };
  struct Box
  {
    Point lower, upper;
  };
  /// Closed when it bounds an area; the last vertex does not repeat the first.
  using Polyline = std::vector<Point>;

  /// Condition on a side of the domain, for every module that knows one. no_flux: fields have zero
  /// normal gradient, material must not reach it; symmetry: the same, and material slides along it;
  /// fixed: fields keep their first value.
  enum class Boundary
  {
    no_flux,
    symmetry,
    periodic,
    fixed
  };

  struct Domain
  {
    Point lower = Point::Zero();
    Point size = Point::Zero();
    std::array<int, 2> cells{0, 0};
    std::array<Boundary, 4> boundary{}; // indexed by Edge
    SourceLocation place;

    Point upper() const { return lower + size; }
    Point spacing() const { return {size[0] / cells[0], size[1] / cells[1]}; }
  };
} // namespace scene
