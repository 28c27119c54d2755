#include "imposed.h"

#include "medium/advection.h"

namespace
{
  void write_component(const scene::Function &function, const double time, const medium::Mesh &mesh,
                       medium::Field<double> &field)
  {
    constexpr int g = medium::ghost_layers;
    const double uniform = function({{}, {}, time});
    for (int j = -g; j < mesh.nodes[1] + g; ++j)
      for (int i = -g; i < mesh.nodes[0] + g; ++i)
      {
        const scene::Point x = mesh.position(i, j);
        field(i, j) = function.depends_on_position() ? function({x, x, time}) : uniform;
      }
  }
} // namespace

Imposed::Imposed(const scene::Imposed &imposed)
    : component{scene::Function(imposed.velocity[0]), scene::Function(imposed.velocity[1])},
      steady(!component[0].depends_on_time() && !component[1].depends_on_time())
{
}

void Imposed::write(const double time, const medium::Mesh &mesh, medium::Velocity &velocity)
{
  if (steady && written)
    return;
  write_component(component[0], time, mesh, velocity.x);
  write_component(component[1], time, mesh, velocity.y);
  rate = medium::crossing_rate(velocity, mesh);
  written = true;
}
