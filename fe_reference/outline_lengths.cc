#include "outline_lengths.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scene/geometry.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    double length_between(const Point &a, const Point &b, const OutlineLengths::PointTest &lies)
    {
      return lies(a) && lies(b) && lies(0.5 * (a + b)) ? (b - a).norm() : 0.;
    }
  } // namespace

  OutlineLengths::OutlineLengths(const scene::Scene &scene, const Discretisation &d) : mesh(d)
  {
    for (const BoundarySide &side : d.boundary)
      longest =
          std::max(longest, (d.position[side.node[d.degree]] - d.position[side.node[0]]).norm());
    outlines = scene::outline(scene.bodies, scene.domain, 0.25 * longest);
  }

  double OutlineLengths::of_mesh(const PointTest &lies) const
  {
    double length = 0.;
    for (const BoundarySide &side : mesh.boundary)
      length +=
          length_between(mesh.position[side.node[0]], mesh.position[side.node[mesh.degree]], lies);
    return length;
  }

  void OutlineLengths::check(const PointTest &lies, const double length,
                             const scene::SourceLocation &place, const std::string &who) const
  {
    double expected = 0.;
    for (const scene::Polyline &outline : outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
        expected += length_between(outline[k], outline[(k + 1) % outline.size()], lies);
    // Chords cut corners all along a rough or wavy outline; an edge that the mesh has left is
    // missed whole.
    constexpr double of_chords = 0.1;
    if (std::abs(length - expected) <= longest + of_chords * expected)
      return;
    std::ostringstream text;
    text << place.file << ":" << place.line << ": " << who << " " << length
         << " of the mesh's outline, of the bodies' it would be " << expected
         << ": the mesh does not follow it there\n  remedy: other [fe] cells";
    throw scene::BadScene(text.str());
  }
} // namespace fe
