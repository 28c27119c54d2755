#include "imposed.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "medium/advection.h"
#include "medium/numerical_error.h"

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
    constexpr double smallest_part = 1e-8;
    if (step >= smallest_part * end)
      return;
    std::ostringstream text;
    text << "the imposed motion crosses a cell so fast that a step is " << step << " of the run's "
         << end << ": imposed.velocity is singular at a node; keep it bounded there";
    throw medium::NumericalError(text.str());
  }
} // namespace

Imposed::Imposed(const scene::Imposed &imposed)
    : component{scene::Function(imposed.velocity[0]), scene::Function(imposed.velocity[1])},
      is_steady(!component[0].depends_on_time() && !component[1].depends_on_time())
{
}

void Imposed::evaluate(const double time, const medium::Mesh &mesh, medium::Velocity &velocity)
{
  if (is_steady && evaluated)
    return;
  write_component(component[0], time, mesh, velocity.x);
  write_component(component[1], time, mesh, velocity.y);
  rate = medium::crossing_rate(velocity, mesh);
  evaluated = true;
}

template <class Visit>
void Imposed::for_sampled_nodes(const medium::Mesh &mesh, Visit &&visit) const
{
  constexpr int stride = 4;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const bool uniform = !component[axis].depends_on_position();
    const int columns = uniform ? 1 : mesh.nodes[0], rows = uniform ? 1 : mesh.nodes[1];
    for (int j = 0; j < rows - 1 + stride; j += stride)
      for (int i = 0; i < columns - 1 + stride; i += stride)
        visit(axis, mesh.position(std::min(i, columns - 1), std::min(j, rows - 1)));
  }
}

double Imposed::crossing_rate(const double time, const medium::Mesh &mesh) const
{
  double fastest = 0.;
  for_sampled_nodes(mesh,
                    [&](const std::size_t axis, const scene::Point &x)
                    {
                      fastest = std::max(fastest, std::abs(component[axis]({x, x, time})) /
                                                      mesh.spacing[static_cast<int>(axis)]);
                    });
  return fastest;
}

bool Imposed::is_constant_over(const double time, const double length, const double spacing,
                               const medium::Mesh &mesh) const
{
  const int samples = std::max(4, static_cast<int>(std::ceil(length / spacing)));
  bool same = true;
  for_sampled_nodes(mesh,
                    [&](const std::size_t axis, const scene::Point &x)
                    {
                      const double now = component[axis]({x, x, time});
                      for (int k = 1; k <= samples && same; ++k)
                        same = component[axis]({x, x, time + k * length / samples}) == now;
                    });
  return same;
}

double Imposed::step(const StepLimits &limits, const medium::Mesh &mesh) const
{
  const auto [time, longest, end, fraction] = limits;
  constexpr double least_steps = 200.; // a motion that changes is resolved by this many at least
  const double now = is_steady ? rate : crossing_rate(time, mesh);
  double length = std::min(longest, end);
  if (now * length > fraction)
    length = fraction / now;
  if (now > 0.)
    refuse_singular(fraction / now, end);
  if (is_steady || is_constant_over(time, length, 0.25 * end / least_steps, mesh))
    return length;
  length = std::min(longest, end / least_steps);
  for (;;)
  {
    double fastest = 0.;
    for (int quarter = 0; quarter <= 4; ++quarter)
      fastest = std::max(fastest, crossing_rate(time + 0.25 * quarter * length, mesh));
    if (fastest * length <= fraction)
      return length;
    refuse_singular(fraction / fastest, end);
    length = std::max(0.999 * fraction / fastest, 0.5 * length);
  }
}
