// Where a marker is.
#pragma once

#include "simulate.h"

namespace simulated
{
  /// Centre of the solid part (1 + phi)/2 along x.
  inline double centre(const World &world)
  {
    double weight = 0., sum = 0.;
    for (int j = 0; j < world.mesh->nodes[1]; ++j)
      for (int i = 0; i < world.mesh->nodes[0]; ++i)
      {
        const double solid = 0.5 * (1. + world.phase->value(i, j));
        weight += solid, sum += solid * world.mesh->position(i, j)[0];
      }
    return sum / weight;
  }
} // namespace simulated
