// A mesh for walls to move through, cells of 0.4.
#pragma once

#include "medium/walls.h"

namespace medium
{
  inline Mesh tall_mesh(int cells_x, int cells_y)
  {
    scene::Domain domain;
    domain.size = {cells_x * 0.4, cells_y * 0.4}, domain.cells = {cells_x, cells_y};
    return make_mesh(domain);
  }
} // namespace medium
