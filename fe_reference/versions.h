// With which libraries a reference was computed.
#pragma once

#include "record/provenance.h"
#include "scene/scene.h"

namespace fe
{
  /// Adds the versions of deal.II and Trilinos, and of Gmsh where it makes the scene's mesh, to
  /// those that the record names by itself.
  void add_versions(record::Provenance &, const scene::Scene &);
} // namespace fe
