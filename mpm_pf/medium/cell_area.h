// How much of one cell of the mesh lies in the solid, {phi > 0}, and where.
//
// The solid part of a cell is the marching-squares polygon whose vertices on the cell's sides are
// the subcell-accurate crossings of contour.h (the root of the cubic through four nodes of the
// straightened profile), so that the areas of all cells add up to what the contour encloses. It is
// at most two convex polygons: a cell with two solid corners across its diagonal is joined or split
// by the sign of the mean of its corners. Between moving walls, nodes behind a wall are not read:
// phi goes on evenly (no flux) to the wall's true place, where the cell ends.
#pragma once

#include <array>
#include <optional>

#include "medium/crossing.h"
#include "medium/field.h"

namespace medium
{
  /// A convex polygon of few vertices, counter-clockwise; it allocates nothing.
  struct ConvexPolygon
  {
    int count = 0;
    std::array<Point, 12> vertex;

    void add(const Point &at) { vertex[static_cast<std::size_t>(count++)] = at; }
  };

  double area(const ConvexPolygon &);    // length^2
  Point centroid(const ConvexPolygon &); // of at least one vertex; their mean if it has no area
  /// What of the polygon lies in the rectangle.
  ConvexPolygon clip(const ConvexPolygon &, const scene::Box &);

  /// The solid in one cell, and the pieces of the contour in it.
  struct CellPart
  {
    int pieces = 0;
    std::array<ConvexPolygon, 2> piece;
    int segments = 0;
    std::array<scene::Segment, 2> segment;

    double area() const; // length^2
  };

  /// Reads the solid part of cells. Cell (i, j) lies between the nodes (i, j) and (i + 1, j + 1).
  class CellAreas
  {
  public:
    /// `active`: the rectangle between moving walls; cells that a wall cuts end there, cells behind
    /// it have no area. Field and mesh must outlive this.
    CellAreas(const Field<double> &, const Mesh &,
              const std::optional<scene::Box> &active = std::nullopt);

    /// Cells [first_cell, end_cell) of an axis have an area.
    int first_cell(int axis) const
    {
      return axes[axis].cut_low ? axes[axis].first - 1 : axes[axis].first;
    }
    int end_cell(int axis) const
    {
      return axes[axis].cut_high ? axes[axis].last + 1 : axes[axis].last;
    }
    /// Does a wall cut cells with this index along the axis?
    bool cut(int axis, int cell) const
    {
      return cell < axes[axis].first || cell >= axes[axis].last;
    }

    scene::Box box(int i, int j) const; // of the cell, ended by the walls
    double whole(int i, int j) const;   // its area; 0 behind a wall
    /// Solid corners, bit k: (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1).
    unsigned corners(int i, int j) const;
    bool interface(int i, int j) const
    {
      const unsigned c = corners(i, j);
      return c != 0u && c != 15u;
    }
    double area(int i, int j) const; // of its solid part, length^2
    CellPart part(int i, int j) const;
    /// Bilinear value of phi at a position inside the domain.
    double value(const Point &) const;

  private:
    struct Axis
    {
      int first = 0, last = 0; // active nodes
      bool cut_low = false, cut_high = false;
      double low = 0., high = 0.; // where the active rectangle ends
      double lower = 0., spacing = 0.;
      int source(int node) const;
      double position(int node) const;
    };
    double node(int i, int j) const { return field(axes[0].source(i), axes[1].source(j)); }
    Point corner(int i, int j) const { return {axes[0].position(i), axes[1].position(j)}; }
    Point crossing(int i, int j, int axis) const;

    const Field<double> &field;
    std::array<Axis, 2> axes;
  };
} // namespace medium
