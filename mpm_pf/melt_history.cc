#include "melt_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "medium/contour.h"
#include "medium/sums.h"
#include "melt/heat_budget.h"
#include "scene/units.h"

namespace
{
  using medium::Field;
  using medium::Mesh;

  double diagonal_defect(const Field<double> &field, const Mesh &mesh)
  {
    double defect = 0.;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < j; ++i)
        defect = std::max(defect, std::abs(field(i, j) - field(j, i)));
    return defect;
  }

  /// |grad phi| at a point, from central differences at the four nodes round it, bilinearly.
  double gradient_at(const Field<double> &phi, const Mesh &mesh, const scene::Point &x)
  {
    const scene::Point at = (x - mesh.lower).cwiseQuotient(mesh.spacing);
    const int i0 = std::clamp(static_cast<int>(at[0]), 0, mesh.nodes[0] - 2);
    const int j0 = std::clamp(static_cast<int>(at[1]), 0, mesh.nodes[1] - 2);
    scene::Point gradient = scene::Point::Zero();
    for (int j = j0; j <= j0 + 1; ++j)
      for (int i = i0; i <= i0 + 1; ++i)
      {
        const double weight = (1. - std::abs(at[0] - i)) * (1. - std::abs(at[1] - j));
        gradient += weight * scene::Point((phi(i + 1, j) - phi(i - 1, j)) / (2 * mesh.spacing[0]),
                                          (phi(i, j + 1) - phi(i, j - 1)) / (2 * mesh.spacing[1]));
      }
    return gradient.norm();
  }

  /// Over the contour inside `box`, a cell away from its border: along a side or a wall the line
  /// closes round the solid where no interface is.
  double mean_interface_width(const Field<double> &phi, const Mesh &mesh, const scene::Box &box,
                              const std::vector<scene::Polyline> &contour)
  {
    double sum = 0.;
    long count = 0;
    for (const auto &line : contour)
      for (const auto &x : line)
        if (((x - box.lower).array() > mesh.spacing.array()).all() &&
            ((box.upper - x).array() > mesh.spacing.array()).all())
        {
          sum += 1. / (std::sqrt(2.) * gradient_at(phi, mesh, x));
          ++count;
        }
    return count > 0 ? sum / static_cast<double>(count) : 0.;
  }
} // namespace

namespace
{
  /// The domain, or the rectangle between the walls.
  scene::Box inner_box(const World &world)
  {
    return world.walls ? medium::active_box(world.walls->cuts, *world.mesh)
                       : medium::extent(*world.mesh);
  }

  /// Integral of theta - phi/2 over the domain, or what the walls have left of it.
  double heat_content(const World &world)
  {
    const medium::Cuts cuts = cuts_of(world);
    if (world.phase)
      return melt::heat_budget(world.phase->value, world.heat->value, *world.mesh, cuts).total();
    const auto &theta = world.heat->value;
    return world.mesh->spacing.prod() * medium::weighted_sum(theta, *world.mesh, cuts);
  }
} // namespace

std::vector<scene::Polyline> phase_contour(const World &world)
{
  std::optional<scene::Box> between_walls;
  if (world.walls)
    between_walls = inner_box(world);
  return medium::contour(world.phase->value, *world.mesh, medium::Profile::tanh_of_distance,
                         between_walls);
}

void HistoryColumns::add(const std::string &name, const std::string &unit, const double value)
{
  names.push_back(name);
  units.push_back(unit);
  values.push_back(value);
}

HistoryColumns melt_history(const World &world)
{
  HistoryColumns row;
  if (!world.mesh)
    return row;
  const Mesh &mesh = *world.mesh;
  const medium::Cuts cuts = cuts_of(world);
  const std::string length = scene::unit_text(scene::Dimension::length, world.scene->units);
  if (world.phase)
  {
    const auto &phi = world.phase->value;
    const auto contour = phase_contour(world);
    const medium::Statistics statistics = medium::statistics_of(phi, mesh, cuts);
    row.add("solid_area", length + "^2", medium::enclosed_area(contour));
    row.add("interface_length", length, medium::interface_length(contour, inner_box(world)));
    row.add("interface_width", length, mean_interface_width(phi, mesh, inner_box(world), contour));
    row.add("phi_min", "1", statistics.min);
    row.add("phi_max", "1", statistics.max);
    if (mesh.nodes[0] == mesh.nodes[1])
      row.add("diagonal_defect", "1", diagonal_defect(phi, mesh));
  }
  if (world.heat)
  {
    const medium::Statistics statistics = medium::statistics_of(world.heat->value, mesh, cuts);
    row.add("theta_mean", "L/cp", statistics.mean);
    row.add("theta_variance", "(L/cp)^2", statistics.variance);
    row.add("theta_min", "L/cp", statistics.min);
    row.add("theta_max", "L/cp", statistics.max);
    row.add("heat_content", "L/cp " + length + "^2", heat_content(world));
    if (world.advection)
      row.add("carried_heat", "L/cp " + length + "^2", world.heat->advected);
    if (world.advection && world.phase)
      row.add("carried_phase", length + "^2", world.phase->advected);
  }
  if (world.growth)
    row.add("active_tiles", "1",
            static_cast<double>(world.growth->tiles().count(medium::Activity::active)));
  return row;
}
