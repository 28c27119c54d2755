#include "solid/mean_velocity.h"

namespace solid
{
  void reset(NodalVelocity &mean, const scene::Domain &domain)
  {
    const std::size_t nodes = static_cast<std::size_t>(domain.cells[0] + 1) * (domain.cells[1] + 1);
    mean.x.assign(nodes, 0.), mean.y.assign(nodes, 0.), mean.mass.assign(nodes, 0.);
  }

  void add(NodalVelocity &mean, const Grid &grid, const scene::Domain &domain, const double weight)
  {
    for_each_node(grid,
                  [&](const int i, const int j, const std::ptrdiff_t n)
                  {
                    if (i < 0 || j < 0 || i > domain.cells[0] || j > domain.cells[1])
                      return;
                    const std::size_t k = static_cast<std::size_t>(j) * (domain.cells[0] + 1) + i;
                    mean.x[k] += weight * grid.nodes[n].momentum()[0];
                    mean.y[k] += weight * grid.nodes[n].momentum()[1];
                    mean.mass[k] += weight * grid.mass[n];
                  });
  }

  void finish(NodalVelocity &mean)
  {
    for (std::size_t k = 0; k < mean.mass.size(); ++k)
      if (mean.mass[k] > 0.)
        mean.x[k] /= mean.mass[k], mean.y[k] /= mean.mass[k];
  }
} // namespace solid
