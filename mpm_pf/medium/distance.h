// Signed distance psi to the phi = 0 contour in a band of tiles around it; positive in the solid.
//
// Default method, closest point: the contour is cut into pieces, one where it crosses each mesh
// line. A piece knows its place (root of the cubic through four nodes of the straightened profile,
// crossing.h), normal and curvature (from a 4 x 5 stencil), so it stands for an arc of the
// osculating circle. A node takes the nearest piece and measures the distance d to that arc,
//   d = (2 m - kappa r^2)/(1 + sqrt(1 - 2 kappa m + kappa^2 r^2)),  r = x - x_piece, m = r.n,
// which is third-order accurate between pieces less than a cell apart (Newton's iteration on the
// bicubic interpolant, Chopp 2001, starts from the same data and moves by less than that). Where no
// circle fits (medial axis, corners) the piece stands for a straight segment, so nothing can
// diverge. The sign is the sign of phi at the node: a measurement cannot move the contour across a
// node.
//
// The alternative, reinitialise() in reinitialisation.h, is the differential equation of Refs.
// [14,15].
#pragma once

#include <vector>

#include "medium/claims.h"
#include "medium/field.h"
#include "medium/tiles.h"

namespace medium
{
  /// The contour where it crosses a mesh line. The curvature is positive where the centre lies on
  /// the solid side.
  struct ContourPiece
  {
    double x, y;               // length
    double normal_x, normal_y; // unit, into the solid
    double curvature;          // 1/length
  };
  static_assert(sizeof(ContourPiece) == 5 * sizeof(double), "gathered as five numbers in a row");

  struct Distance
  {
    /// Room for the band; `band_cells`: its half-width in cells (of the larger spacing), at
    /// least 3.
    Distance(const Mesh &, double band_cells);

    double band;          // half-width, length
    Field<double> psi;    // length; beyond the band +-band
    Field<int> piece;     // nearest piece; -1 beyond the band
    Field<double> offset; // of the closest point from the piece along (-normal_y, normal_x), length
    std::vector<ContourPiece> pieces; // in the order of their rows
    std::vector<int> first_of_row;    // first piece with row(y) >= j, for j = 0 ... rows

    Tiles tiles; // active: the tile may hold nodes of the band (at first: any); else frozen
    Tiles close; // active: the tile comes within `follow_cells` of the contour
    std::vector<Claims> claims; // scratch of each thread
  };

  /// How far, in cells, the contour may move from one measurement to one that follows it.
  inline constexpr double follow_cells = 3.;

  /// Measures the distance to the zero contour of `phi`, whose ghosts must be filled. Cost grows
  /// with the length of the contour times the width of the band; beyond it only sign changes are
  /// looked for, and fields are written only in tiles that the band covers or has left since the
  /// last call.
  template <class T>
  void compute_distance(Distance &, const Field<T> &phi, const Mesh &);

  /// The same where the contour has moved by less than `follow_cells` since the last measurement
  /// and has no new parts elsewhere: sign changes are looked for in the tiles it was close to.
  /// Result and order are those of compute_distance(), at a cost that knows nothing of the rest of
  /// the mesh.
  template <class T>
  void update_distance(Distance &, const Field<T> &phi, const Mesh &);

  /// The point of the contour closest to node (i, j), which must lie in the band.
  Point closest_point(const Distance &, int i, int j);
} // namespace medium
