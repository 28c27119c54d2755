// The mesh's vertices on curved outlines.
//
// The outline is meshed as chords up to 0.02 cells off it, an error that shrinks only with the
// first power of the cell. The vertices that the mesh put on the chords are moved onto the outline:
// sides are chords between points of it, as long as a cell, off by its square.
#pragma once

#include "mesh.h"

namespace fe
{
  /// Moves every vertex on the boundary of the mesh, if by no more than `farthest`, to the nearest
  /// point of the outlines, unless a cell would lose its shape.
  void follow_outline(QuadMesh &, const std::vector<scene::Polyline> &outlines, double farthest);
} // namespace fe
