#include "quadrature.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scene/geometry.h"

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

std::string warning_on_thin_bodies(const World &world)
{
  constexpr double enough = 2.; // cells
  const scene::Scene &scene = *world.scene;
  if (!scene.solid || scene.growth)
    return {};
  const double dx = scene.domain.spacing().maxCoeff();
  const double rounding = 1e-6 * dx;
  std::ostringstream text;
  text.precision(2);
  for (const scene::Body &body : scene.bodies)
  {
    double area = 0., perimeter = 0.;
    for (const scene::Polyline &line : scene::outline({body}, scene.domain, dx))
    {
      area += scene::signed_area(line);
      for (std::size_t k = 0; k < line.size(); ++k)
      {
        const scene::Point &a = line[k], &b = line[(k + 1) % line.size()];
        const auto goes_on_across = [&](const int axis)
        {
          return std::abs(a[axis] - b[axis]) <= rounding &&
                 on_symmetry_side(scene.domain, axis, a, rounding);
        };
        if (!goes_on_across(0) && !goes_on_across(1)) // else the cut through a larger body
          perimeter += (b - a).norm();
      }
    }
    if (const double width = 2. * area / perimeter / dx; width < enough)
      text << (text.str().empty() ? "thin: " : ", ") << '"' << body.name << "\" is about " << width
           << " cells wide";
  }
  if (!text.str().empty())
    text << "; below " << enough
         << " neither bending nor edges are resolved: give more domain.cells";
  return text.str();
}
