// Units of what stands in a scene and in a record, as text.
#pragma once

#include <string>
#include <string_view>

#include "scene/domain.h"

namespace scene
{
  enum class Dimension
  {
    none,
    length,
    area,
    time,
    speed,
    inverse_speed,
    acceleration,
    stress,
    density,
    viscosity,
    diffusivity,
    degrees,
    force, // this and the following by unit of depth, as in any plane problem
    energy,
    momentum,
    mass
  };

  /// "Pa" or "sigma_Y"; "" for pure numbers.
  std::string unit_text(Dimension, Units);
  /// The same for the column of a table: "1" for pure numbers.
  std::string column_unit(Dimension, Units);

  /// Dimension of one of the solid_quantities or melt_quantities.
  Dimension dimension_of(std::string_view quantity);
} // namespace scene
