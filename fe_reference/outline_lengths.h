// What the mesh holds or loads of the outline, against what the bodies have there.
//
// Nodes are held and sides loaded if they lie on an edge or a segment to rounding. A mesh that
// leaves its line by more holds nothing, and the answer is wrong without a sign of it: the lengths
// of both must agree to a cell and a tenth, which chords of a rough outline may lose.
#pragma once

#include <functional>
#include <string>

#include "loads.h"

namespace fe
{
  class OutlineLengths
  {
  public:
    OutlineLengths(const scene::Scene &, const Discretisation &);

    using PointTest = std::function<bool(const Point &)>;

    /// Length of the mesh's outline whose sides lie there.
    double of_mesh(const PointTest &) const;
    /// Throws scene::BadScene if `length` of the mesh is `held` (or loaded, as a text) by `who`,
    /// yet the bodies' outline lies there for a length that differs by more than that.
    void check(const PointTest &, double length, const scene::SourceLocation &,
               const std::string &who) const;

  private:
    const Discretisation &mesh;
    double longest = 0.; // side of the mesh
    std::vector<scene::Polyline> outlines;
  };
} // namespace fe
