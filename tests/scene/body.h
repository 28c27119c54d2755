// Bodies of a shape and nothing else.
#pragma once

#include "scene/bodies.h"

namespace scene_test
{
  template <class Shape>
  scene::Body body(const Shape &shape)
  {
    scene::Body result;
    result.shape = shape;
    return result;
  }
} // namespace scene_test
