// The bodies as the phase field sees them: signed distance to their liquid-solid interface.
//
// Three things are outlines of bodies but no interfaces: an edge that lies on a side of the domain
// (nothing is beyond it), what reaches over a symmetry side, and the seam of two bodies that touch
// or overlap. A profile tanh(d/(sqrt(2) W0)) of the plain distance would open a groove of melt
// along each.
#pragma once

#include <optional>
#include <vector>

#include "scene/geometry.h"

namespace scene
{
  class InterfaceDistance
  {
  public:
    /// Distances deeper inside than `depth` may be too small, never below `depth`: there the
    /// profile is flat. Curves of joined bodies are chords of `spacing`.
    InterfaceDistance(std::vector<Body>, const Domain &, double depth, double spacing);

    /// Signed distance of `p` to the interface, positive inside; infinite where there is none.
    double operator()(const Point &p) const;

  private:
    std::vector<Body> bodies;
    std::optional<Body> joined;
    double depth;
  };

  /// The bodies with each straight edge that lies on a side of the domain moved far beyond it.
  std::vector<Body> opened_at_sides(std::vector<Body>, const Domain &);
} // namespace scene
