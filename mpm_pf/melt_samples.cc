#include "melt_samples.h"

#include <algorithm>
#include <limits>

namespace
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  double bilinear(const medium::Field<double> &field, const medium::Mesh &mesh,
                  const scene::Point &x)
  {
    const scene::Point at = (x - mesh.lower).cwiseQuotient(mesh.spacing);
    if (at[0] < 0 || at[1] < 0 || at[0] > mesh.nodes[0] - 1 || at[1] > mesh.nodes[1] - 1)
      return missing;
    const int i = std::min(static_cast<int>(at[0]), mesh.nodes[0] - 2);
    const int j = std::min(static_cast<int>(at[1]), mesh.nodes[1] - 2);
    const double p = at[0] - i, q = at[1] - j;
    return (1 - q) * ((1 - p) * field(i, j) + p * field(i + 1, j)) +
           q * ((1 - p) * field(i, j + 1) + p * field(i + 1, j + 1));
  }

  double value_of(const World &world, const std::string &name, const scene::Point &x)
  {
    if (name == "phi" && world.phase)
      return bilinear(world.phase->value, *world.mesh, x);
    if (name == "theta" && world.heat)
      return bilinear(world.heat->value, *world.mesh, x);
    if (name == "crystal_angle" && world.orientation)
      return world.orientation->varying() ? bilinear(world.orientation->angle, *world.mesh, x)
                                          : world.orientation->uniform_angle;
    if (name == "velocity_x" && world.imposed)
      return bilinear(world.velocity->x, *world.mesh, x);
    if (name == "velocity_y" && world.imposed)
      return bilinear(world.velocity->y, *world.mesh, x);
    return missing;
  }
} // namespace

BetweenWalls::BetweenWalls(const World &world)
    : lower(scene::Point::Constant(-std::numeric_limits<double>::infinity())), upper(-lower)
{
  if (!world.walls)
    return;
  const auto box = medium::active_box(world.walls->cuts, *world.mesh);
  const scene::Point slack = 1e-9 * world.mesh->spacing;
  lower = box.lower - slack, upper = box.upper + slack;
}

bool BetweenWalls::holds(const scene::Point &x) const
{
  return (x.array() >= lower.array()).all() && (x.array() <= upper.array()).all();
}

record::LineSample sample_melt(const World &world, std::vector<scene::Point> positions,
                               const std::vector<std::string> &of)
{
  record::LineSample sample;
  const BetweenWalls between(world);
  for (const auto &x : positions)
    for (const auto &name : of)
      sample.values.push_back(between.holds(x) ? value_of(world, name, x) : missing);
  sample.position = std::move(positions);
  return sample;
}

void overlay(std::vector<double> &values, const std::vector<std::string> &of,
             const std::vector<double> &solid, const std::vector<std::string> &names)
{
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    const auto column = std::find(of.begin(), of.end(), names[k]) - of.begin();
    for (std::size_t row = 0; row * of.size() < values.size(); ++row)
      values[row * of.size() + column] = solid[row * names.size() + k];
  }
}

std::vector<scene::Point> positions_of(const scene::LineProbe &line)
{
  std::vector<scene::Point> positions;
  for (int k = 0; k < line.points; ++k)
    positions.push_back(line.a +
                        (line.b - line.a) * (line.points > 1 ? k / (line.points - 1.) : 0.));
  return positions;
}
