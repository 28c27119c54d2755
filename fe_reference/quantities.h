// The named quantities of scene/quantities.h at one integration point.
#pragma once

#include <string>
#include <vector>

#include "assembly.h"
#include "record/writer.h"

namespace fe
{
  /// One integration point, or one sample taken from it.
  struct Sample
  {
    const PointState *point = nullptr;
    Point displacement = Point::Zero(), velocity = Point::Zero();
    double area = 0.; // current area that it stands for
  };

  /// A function of a sample by its name. Throws std::invalid_argument for a quantity that a solid
  /// does not have (phi, theta ...).
  using Quantity = double (*)(const Material &, const Sample &);
  Quantity quantity(const std::string &name);

  /// Is it averaged over bins (stress, plastic strain ...) rather than interpolated (displacement,
  /// velocity)?
  bool is_binned(const std::string &name);

  /// Names and units of columns, in the scene's system.
  record::Columns columns_of(const std::vector<std::string> &names, scene::Units);
} // namespace fe
