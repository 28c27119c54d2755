// Extension of the solid's velocity (and crystal angle) into the melt: the liquid at any point has
// the velocity of the closest solid, so n . grad q = 0 along the normals n of the front
// (Secs. 2.1, 2.2; Refs. [13]-[15] of the paper).
//
// Default method, closest point. Each piece of the phi = 0 contour (distance.h) carries the value
// and the gradient of the quantity there: a weighted least-squares line through the *solid* nodes
// around it. Solid is what has material and lies deeper than `depth` below the contour: nodal
// velocities nearer to it rest on hardly any mass and count as liquid. A node in the liquid band
// takes the value at its closest point, piece value + tangential slope x offset: exact for uniform
// fields, second order for smooth ones. A node inside the contour without enough material is filled
// with the whole line. Beyond the band a node takes the value of the (nearly) nearest piece, whose
// map is rebuilt only now and then, every map_interval-th call. The distance is measured at every
// call, or at every interval-th; in between the values are those of the solid where the contour
// was, first order in the way that it has gone since. Across the medial axis between two arms the
// extension jumps; that is inherent.
//
// The paper's way, q_tau + n . grad q = 0 marched to rest in the band (Ref. [13]), is the choice
// `pde`; it is first order and needs some three sweeps per cell of the band.
#pragma once

#include <vector>

#include "medium/piece_values.h"
#include "record/writer.h"

namespace medium
{
  struct Extension
  {
    /// `front_width`: W0 of the profile, length; the pde method starts its distance from it.
    Extension(const Mesh &, const scene::Extension &, double front_width);

    scene::ExtensionMethod method;
    double front_width;
    double depth;     // length below the contour from which a node counts as solid: half a cell
    int interval;     // calls from one measurement of the distance to the next, at most: where the
                      // contour has moved on by a cell, it is measured before
    int map_interval; // calls from one update of the whole mesh (map beyond the band, new grains of
                      // the contour) to the next; in between the contour is followed
    long calls = 0;   // since the map was to be rebuilt
    int since_measured = 0; // calls since the distance was measured
    Distance distance;
    Field<int> nearest_piece;         // at every node: the map, numbered as when it was built
    std::vector<Point> mapped_pieces; // places of the pieces then
    std::vector<double> far_value;    // scratch: values by those numbers
    /// What the solid knows at the contour of the fields extended last, by field and piece.
    std::vector<std::vector<PieceValue>> at_pieces;
    record::Profile::Part measuring{"distance"}; // time that the distance took
  };

  /// Gives every node outside the solid a value of each of `fields` (any unit); nodes in the solid
  /// are left alone; ghosts are not filled. `phi`: its ghosts must be filled. `material`: 1 where a
  /// node has mass enough, else 0; an empty field means everywhere. Where no node at all is solid
  /// the fields become 0. A piece without solid nodes around (a grain that has no material) takes
  /// the value of the nearest piece that has. Between two calls the contour must not move by more
  /// than two cells (with the one that it may have moved before, follow_cells).
  template <class T>
  void extend_into_liquid(Extension &, const std::vector<Field<double> *> &fields,
                          const Field<T> &phi, const Field<unsigned char> &material, const Mesh &);

  /// What the solid knows of other fields at the contour that the last extend_into_liquid followed,
  /// in its place in `at_pieces`; no field is changed. `material` as there.
  void fit_at_pieces(Extension &, const std::vector<Field<double> *> &fields,
                     const Field<unsigned char> &material, const Mesh &);

  /// The same for what the solid remembers and new solid inherits, the crystal angle: every node
  /// with phi > 0 keeps its own, the liquid takes the value at the front, reached without slope
  /// along the normal (Approach::level in piece_values.h). Distance and map are those of the last
  /// extend_into_liquid. Throws std::logic_error if there was none.
  void extend_inherited(Extension &, const std::vector<Field<double> *> &fields, const Mesh &);

  /// Memory that grows with the mesh.
  inline std::size_t bytes(const Extension &extension)
  {
    const Distance &distance = extension.distance;
    return distance.psi.bytes() + distance.piece.bytes() + distance.offset.bytes() +
           extension.nearest_piece.bytes();
  }

  /// For a checkpoint: the map beyond the band, which is older than the present contour; and back
  /// into an extension of the same mesh, which then goes on to the same bits. unpack throws
  /// std::runtime_error if the numbers are of another mesh.
  std::vector<double> pack(const Extension &, const Mesh &);
  void unpack(Extension &, const Mesh &, const std::vector<double> &);
  /// The same of a distance that is older than the present contour, as with an interval above 1.
  std::vector<double> pack_distance(const Extension &, const Mesh &);
  void unpack_distance(Extension &, const Mesh &, const std::vector<double> &);
} // namespace medium
