// By how much may the density of a scene's solid be scaled? Only where inertia says nothing.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace scene
{
  /// Does the displacement of the support change with time? Throws BadExpression.
  bool is_driven(const Support &);
  /// Does the body start with a velocity? Throws BadExpression.
  bool has_initial_velocity(const Body &);

  /// The Mach number to scale to, at most `wanted`, or none where the density stays. It stays if
  /// the solid is driven by anything whose time scale is the true density's (traction, body force,
  /// a throw), or so fast or briefly that waves tell: a wave running down a bar is driven by a
  /// support too. Below `wanted` it keeps to what lets a scaled wave cross the bodies `crossings`
  /// times while their supports or walls go as far as they ever go: a bar whose ends move by a
  /// thousandth of its length needs 1e-4 for ten. Inertia's share of a smooth load falls with the
  /// square of that number. Never below the true one, so that scaling makes the density larger.
  std::optional<double> scaled_mach(const Scene &, double wanted, double crossings);
} // namespace scene
