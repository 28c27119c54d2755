#include "capacity.h"

#include <algorithm>
#include <sstream>

#include "record/provenance.h"
#include "scene/geometry.h"
#include "scene/reader.h"
#include "solid/points.h"

double least_bytes(const scene::Scene &scene)
{
  const auto &domain = scene.domain;
  const double nodes = (domain.cells[0] + 1.) * (domain.cells[1] + 1.);
  double fields = scene.solid ? 1. : 0.; // the map of the solid's tiles and neighbours
  fields += scene.phase_field ? 2. : 0.;
  fields += scene.heat ? 2. : 0.;
  double bytes = nodes * 8. * fields;
  if (!scene.solid)
    return bytes;
  const scene::Mpm settings = scene.mpm.value_or(scene::Mpm{});
  double area = 0.;
  for (const auto &line : scene::union_outline(scene.bodies, 0.01 * domain.size.norm()))
    area += scene::signed_area(line);
  const double per_cell = settings.points_per_cell[0] * settings.points_per_cell[1];
  // a body may reach over symmetry sides
  bytes += std::min(area, domain.size.prod()) / domain.spacing().prod() * per_cell *
           static_cast<double>(solid::bytes_per_point());
  return bytes;
}

void refuse_more_than_memory(const scene::Scene &scene, const double bytes)
{
  const double has = record::machine_bytes();
  if (bytes <= has)
    return;
  const auto &domain = scene.domain;
  std::ostringstream text;
  text.precision(3);
  text << domain.place.file << ":" << domain.place.line << ": domain.cells: " << domain.cells[0]
       << " x " << domain.cells[1] << " cells take at least " << bytes / 1e9
       << " GB; this machine has " << has / 1e9 << " GB\n  remedy: fewer cells";
  if (scene.solid)
    text << ", or fewer mpm.points_per_cell";
  throw scene::BadScene(text.str());
}
