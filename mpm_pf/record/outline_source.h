// Bodies that start from what an earlier run observed: the outline of a dendrite, a deformed bar.
//
// The scene only names the record; here the outline is read, cut straight where the scene says so,
// and handed on as a polygon, so that both solvers start from the very same vertices. The cut is
// our own and not a general polygon intersection: a half-plane needs only the crossings with one
// horizontal line, joined in pairs, and leaves every other vertex as it was, bit for bit.
#pragma once

#include "scene/scene.h"

namespace record
{
  /// Replace every RecordedOutline among the bodies by the Polygon it stands for; paths are
  /// as the scene's reader made them, beside the scene file. The vertices enter the hash of the
  /// scene, which stays as it is if no body is taken from a record. Throws scene::BadScene (place,
  /// cause, remedy) if the record, the probe or the time is missing or nothing is left after the
  /// cuts.
  void resolve_outlines(scene::Scene &);

  /// What lies below the line y = `height` of the area that the closed curves bound by the
  /// even-odd rule, as closed curves; new edges lie exactly on the line.
  std::vector<scene::Polyline> cut_above(const std::vector<scene::Polyline> &, double height);
} // namespace record
