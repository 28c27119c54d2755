// One definition of the bodies for points, phase field and finite-element mesh.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace scene
{
  /// Signed distance of `p` to the outline of one body or of the union of bodies, positive inside
  /// the solid. Exact for one body; for a union the largest of the bodies' distances. Throws
  /// BadScene for a RecordedOutline that has not been replaced by its polygon.
  double signed_distance(const Body &, const Point &p);
  double signed_distance(const std::vector<Body> &, const Point &p);

  /// Does material start in the box? Looked up on a fine grid over what it shares with each body.
  bool holds_material(const Box &, const std::vector<Body> &);

  /// Smallest box around all bodies.
  Box bounding_box(const std::vector<Body> &);

  /// Outline of the union as closed polylines; curves are chords of at most `spacing`.
  std::vector<Polyline> union_outline(const std::vector<Body> &, double spacing);

  /// One polygon of all bodies, without the seams of those that touch or overlap; nothing where
  /// none do. Curves are chords of at most `spacing`.
  std::optional<Body> joined_where_they_touch(const std::vector<Body> &, double spacing);

  /// Outline of the union as closed polylines, vertices at most `spacing` apart (circles and edges
  /// are subdivided).
  std::vector<Polyline> outline(const std::vector<Body> &, double spacing);
  /// The same, with what lies beyond the symmetry sides of `domain` cut off.
  std::vector<Polyline> outline(const std::vector<Body> &, const Domain &, double spacing);

  /// Where on the segment, from 0 at `a` to 1 at `b`, the point nearest to `p` is.
  inline double along_segment(const Point &p, const Point &a, const Point &b)
  {
    const Point edge = b - a;
    const double length2 = edge.squaredNorm();
    return length2 > 0. ? std::clamp((p - a).dot(edge) / length2, 0., 1.) : 0.;
  }
  double distance_to_segment(const Point &p, const Point &a, const Point &b);

  /// Is `X` on a symmetry side of the domain whose normal is `axis`?
  bool on_symmetry_side(const Domain &, int axis, const Point &X, double tolerance);
  /// Is that side a symmetry side, and do bodies in the box reach over it by more than `by`?
  bool reaches_over_symmetry(const Domain &, Edge, const Box &bodies, double by);

  /// Side of the squares in which stresses are averaged where a probe names none: it is part of
  /// what is asked, and so the same for both solvers.
  double default_bin(const Scene &);

  /// Do two sides of a closed polyline meet other than at their common vertex?
  bool crosses_itself(const Polyline &);
  /// Area that two closed polylines both enclose.
  double shared_area(const Polyline &, const Polyline &);

  /// Area by the shoelace formula, positive for counter-clockwise.
  double signed_area(const Polyline &);

  /// Is `X` (initial position) part of what `where` names? Outline parts are matched within
  /// `tolerance`.
  bool contains(const Where &, const Box &bodies_box, const Point &X, double tolerance);
} // namespace scene
