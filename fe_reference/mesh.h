// The initial mesh: quadrilaterals that fill the bodies.
//
// Unions of rectangles get a structured mesh whose grid lines pass through every edge of every
// rectangle; cells outside the union are left out. Supports and loads on a part of an edge or in a
// box end between elements, not inside one: there is a grid line, or a vertex of the outline and
// lines along a held box (support_lines.h), too. On request the lines crowd towards the corners
// where a support ends (a clamped corner is singular, stress ~ r^(lambda-1)): between two such
// corners positions follow the power grading s^(1/(1-grading)), which restores the order that a
// uniform mesh loses there (I. Babuska, R. B. Kellogg, J. Pitkaranta, Numer. Math. 33 (1979) 447).
// Discs, rings, polygons and unions that hold one of them are meshed inside their common outline by
// Gmsh, triangles recombined and subdivided into quadrilaterals; sides are straight, their ends on
// the outline (follow_outline.h). What lies beyond a symmetry side of the domain is left out.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace fe
{
  using scene::Point;

  struct QuadMesh
  {
    std::vector<Point> vertices;
    std::vector<std::array<int, 4>> cells; // counter-clockwise
  };

  /// Cells asked for over the bounding box of the bodies: [fe] cells, else the domain's spacing.
  std::array<int, 2> wanted_cells(const scene::Scene &);

  /// How far from an edge or segment a node still lies on it.
  double matching_tolerance(const scene::Box &bodies);

  /// Area of the mesh over that within the bodies' outline.
  double filled_fraction(const scene::Scene &, const QuadMesh &);

  /// Then the mesh is structured, else Gmsh makes it.
  bool are_all_rectangles(const std::vector<scene::Body> &);

  /// Throws scene::BadScene if a body has no area or the bodies fall apart into pieces of which one
  /// touches neither a support nor a symmetry side (it could move freely).
  QuadMesh make_mesh(const scene::Scene &);

  /// The two ways, by shape. `spacing`: wanted size of a cell; `ends`: where supports and loads
  /// end.
  QuadMesh mesh_rectangles(const std::vector<scene::Body> &, const std::array<int, 2> &cells,
                           double grading, const std::vector<scene::Support> &,
                           const std::vector<scene::Where> &parts = {});
  QuadMesh mesh_outline(const std::vector<scene::Body> &, const scene::Domain &,
                        const Point &spacing, const std::vector<scene::Where> &parts = {},
                        const std::vector<scene::Support> &held = {});
} // namespace fe
