#include "imposed.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "medium/advection.h"
#include "medium/trouble.h"

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

  /// A velocity without bound near a node would let the run stand still.
  void refuse_singular(const double step, const double end)
  {
    constexpr double least_part = 1e-8;
    if (step >= least_part * end)
      return;
    std::ostringstream text;
    text << "the imposed motion crosses a cell so fast that a step is " << step << " of the run's "
         << end << ": imposed.velocity is singular at a node; keep it bounded there";
    throw medium::NumericalTrouble(text.str());
  }
} // namespace

Imposed::Imposed(const scene::Imposed &imposed)
    : component{scene::Function(imposed.velocity[0]), scene::Function(imposed.velocity[1])},
      is_steady(!component[0].depends_on_time() && !component[1].depends_on_time())
{
}

void Imposed::write(const double time, const medium::Mesh &mesh, medium::Velocity &velocity)
{
  if (is_steady && written)
    return;
  write_component(component[0], time, mesh, velocity.x);
  write_component(component[1], time, mesh, velocity.y);
  rate = medium::crossing_rate(velocity, mesh);
  written = true;
}

double Imposed::crossing_rate(const double time, const medium::Mesh &mesh) const
{
  constexpr int stride = 4;
  double fastest = 0.;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const bool uniform = !component[axis].depends_on_position();
    for (int j = 0; j < mesh.nodes[1] - 1 + stride; j += uniform ? mesh.nodes[1] + stride : stride)
      for (int i = 0; i < mesh.nodes[0] - 1 + stride;
           i += uniform ? mesh.nodes[0] + stride : stride)
      {
        const scene::Point x =
            mesh.position(std::min(i, mesh.nodes[0] - 1), std::min(j, mesh.nodes[1] - 1));
        fastest = std::max(fastest, std::abs(component[axis]({x, x, time})) /
                                        mesh.spacing[static_cast<int>(axis)]);
      }
  }
  return fastest;
}

double Imposed::step(const double time, const double longest, const double end,
                     const double fraction, const medium::Mesh &mesh) const
{
  constexpr double least_steps = 200.; // an unsteady motion is resolved by this many at least
  double length = std::min(longest, is_steady ? end : end / least_steps);
  for (;;)
  {
    double fastest = is_steady ? rate : 0.;
    for (int quarter = 0; quarter <= 4 && !is_steady; ++quarter)
      fastest = std::max(fastest, crossing_rate(time + 0.25 * quarter * length, mesh));
    if (fastest * length <= fraction)
      return length;
    refuse_singular(fraction / fastest, end);
    if (is_steady)
      return fraction / fastest;
    length = std::max(0.999 * fraction / fastest, 0.5 * length);
  }
}
