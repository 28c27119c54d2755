#include "versions.h"

#include <Trilinos_version.h>
#include <deal.II/base/config.h>
#include <gmsh.h>

#include "mesh.h"

namespace fe
{
  void add_versions(record::Provenance &provenance, const scene::Scene &scene)
  {
    provenance["deal.II"] = DEAL_II_PACKAGE_VERSION;
    provenance["trilinos"] = TRILINOS_VERSION_STRING;
    if (!are_all_rectangles(scene.bodies))
      provenance["gmsh"] = GMSH_API_VERSION;
  }
} // namespace fe
