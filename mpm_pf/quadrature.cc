#include "quadrature.h"

#include <algorithm>
#include <cmath>
#include <sstream>

std::string warning_on_quadrature(const World &world)
{
  constexpr double strained = 0.01, far = 3.; // cells
  constexpr int enough = 3;                   // points a cell and axis
  const scene::Scene &scene = *world.scene;
  if (!world.solid || solid::points(*world.solid) == 0)
    return {};
  const auto &[nx, ny] = scene.mpm.value_or(scene::Mpm{}).points_per_cell;
  if (std::min(nx, ny) >= enough)
    return {};
  const record::Snapshot points =
      solid::snapshot(*world.solid, {"von_mises", "displacement_x", "displacement_y"});
  double sum = 0., moved = 0.;
  for (const double stress : points.fields.at("von_mises"))
    sum += stress;
  for (const char *component : {"displacement_x", "displacement_y"})
    for (const double displacement : points.fields.at(component))
      moved = std::max(moved, std::abs(displacement));
  const double strain = sum / points.vertex.size() / scene.solid->young_modulus;
  const double cells = moved / scene.domain.spacing()[0];
  if (!(strain > strained) || !(cells > far))
    return {};
  std::ostringstream text;
  text.precision(2);
  text << "coarse quadrature: elastic strains of " << 100. * strain << " % in the mean, moved over "
       << cells << " cells with " << nx << " x " << ny
       << " points a cell, creep by percents of themselves; give mpm.points_per_cell = [4, 4]";
  return text.str();
}
