#include "front_warnings.h"

#include <cmath>
#include <sstream>

#include "medium/contour.h"
#include "melt_history.h"
#include "scene/choices.h"
#include "solid/energy.h"

namespace
{
  bool solid_at(const medium::Field<double> &phi, const medium::Mesh &mesh, const scene::Edge side)
  {
    const bool across_x = side == scene::Edge::left || side == scene::Edge::right;
    const int last = mesh.nodes[across_x ? 0 : 1] - 1, along = mesh.nodes[across_x ? 1 : 0];
    const int line = side == scene::Edge::left || side == scene::Edge::bottom ? 0 : last;
    for (int n = 0; n < along; ++n)
      if ((across_x ? phi(line, n) : phi(n, line)) > 0.)
        return true;
    return false;
  }
} // namespace

std::string warning_on_sides(const World &world)
{
  if (!world.solid || !world.scene->growth || solid::points(*world.solid) == 0)
    return {};
  std::string sides;
  for (const auto side :
       {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
    if (world.mesh->side(side) != scene::Boundary::symmetry &&
        !(world.walls && world.walls->at(side)) && solid_at(world.phase->value, *world.mesh, side))
      sides += (sides.empty() ? "" : ", ") + scene::word(side);
  if (sides.empty())
    return {};
  return "solid stands at the " + sides +
         " of the domain: the phase field goes on there, the material ends with a free surface; "
         "enlarge domain.size, or make it a symmetry side or a wall";
}

std::string warning_on_melted_crystals(const World &world)
{
  const scene::Scene &scene = *world.scene;
  if (!scene.growth || !scene.heat || !world.phase || !phase_contour(world).empty())
    return {};
  std::ostringstream text;
  text.precision(3);
  text << "the crystal has melted away: phi > 0 is nowhere at the end, and what is recorded later "
          "than that is of melt alone; ";
  if (scene.heat->initial)
    text << "give a colder heat.initial or a larger body";
  else
    text << "give a larger body (one of a radius below d0/Delta = "
         << scene.growth->capillary_length / scene.heat->undercooling
         << " must melt, one of a few W0 may) or more heat.undercooling";
  return text.str();
}

std::string warning_on_areas(const World &world)
{
  if (!world.solid || !world.phase || solid::points(*world.solid) == 0)
    return {};
  const double of_points = solid::area(*world.solid);
  const double of_phi = medium::enclosed_area(phase_contour(world));
  if (std::abs(of_phi - of_points) <= 0.05 * of_points)
    return {};
  std::ostringstream text;
  text.precision(3);
  text << "phi > 0 covers " << of_phi << ", the material points " << of_points
       << ": the front is not where the material is; shorten advection.step_fraction, refine "
          "domain.cells, or look where the body left a wall";
  return text.str();
}
