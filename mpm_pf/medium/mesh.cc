#include "medium/mesh.h"

#include <stdexcept>
#include <string>

namespace medium
{
  Mesh make_mesh(const scene::Domain &domain)
  {
    static_assert(scene::fewest_cells >= ghost_layers, "what scenes may ask for has room");
    Mesh mesh;
    mesh.nodes = {domain.cells[0] + 1, domain.cells[1] + 1};
    mesh.lower = domain.lower;
    mesh.spacing = domain.spacing();
    mesh.boundary = domain.boundary;
    const std::string where =
        domain.place.file.empty()
            ? std::string{}
            : domain.place.file + ":" + std::to_string(domain.place.line) + ": ";
    for (const int cells : domain.cells)
      if (cells < ghost_layers)
        throw std::invalid_argument(where + "domain.cells: read " + std::to_string(cells) +
                                    "; at least " + std::to_string(ghost_layers) +
                                    " cells are needed each way, because the widest stencil "
                                    "mirrors that many; refine the mesh");
    const auto periodic = [&](Edge edge) { return mesh.side(edge) == Boundary::periodic; };
    if (periodic(Edge::left) != periodic(Edge::right) ||
        periodic(Edge::bottom) != periodic(Edge::top))
      throw std::invalid_argument(where +
                                  "domain.boundary: a periodic side needs its opposite side "
                                  "to be periodic as well");
    return mesh;
  }

  int source_index(int index, int count, Boundary low, Boundary high)
  {
    const int last = count - 1;
    if (index < 0)
      return low == Boundary::periodic ? index + last : -index;
    if (index > last)
      return high == Boundary::periodic ? index - last : 2 * last - index;
    return index;
  }
} // namespace medium
