// Massless points on the first outline: where the surface of the material is.
//
// They are carried by the transferred nodal velocity before forces, p_i/m_i, which extends a linear
// field of the points beyond them, and by the acceleration of the mass around: the velocity after
// forces is of no use there, since the lightest nodes take the largest accelerations, and without
// them the outline of a body that turns would spiral away from its points. Chords longer than a
// cell are halved. They mark the held and loaded parts of the outline, too.
#pragma once

#include <algorithm>

#include "solid/transfer.h"

namespace solid
{
  struct Tracer
  {
    Point X, x;
    std::uint32_t lines = 0; // those of the held lines on which it sits, by their bits
    int grip = -1;           // rigid grip with which it moves
    std::uint32_t loads = 0; // bit k: the chord to the next tracer carries load k
  };

  struct Tracers
  {
    std::vector<std::vector<Tracer>> outlines; // closed
  };

  /// How far from an edge or segment what starts on it may lie: of a cell, or, on fine grids, of
  /// the bodies, whose own numbers are rounded.
  inline double place_tolerance(const scene::Box &bodies, const double dx)
  {
    return std::max(1e-6 * dx, 1e-7 * (bodies.upper - bodies.lower).norm());
  }

  /// On the outline of the bodies, cut at the symmetry sides of the domain.
  Tracers make_tracers(const std::vector<scene::Body> &, const scene::Domain &, double spacing);

  /// Interpolated transferred velocity at x, nodes without mass left out, and what forces and
  /// supports add to it, as a mean by mass. Zero far from material.
  Point transferred_velocity(const Interpolation &, const Point &x);

  /// Carry the free tracers by dt.
  void move(Tracers &, const Interpolation &, double dt);
  /// Halve chords longer than `longest`.
  void refine(Tracers &, double longest);

  /// Two Gauss points of a chord, each for half its length.
  inline constexpr double chord_gauss_points[2] = {0.5 - 0.28867513459481287,
                                                   0.5 + 0.28867513459481287};

  /// Initial and current position interpolated along the chord from tracer k, 0 <= s <= 1.
  inline std::array<Point, 2> on_chord(const std::vector<Tracer> &outline, const std::size_t k,
                                       const double s)
  {
    const Tracer &a = outline[k], &b = outline[(k + 1) % outline.size()];
    return {Point((1. - s) * a.X + s * b.X), Point((1. - s) * a.x + s * b.x)};
  }
} // namespace solid
