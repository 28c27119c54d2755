// May the density of a scene's solid be scaled? Only if inertia says nothing there.
#pragma once

#include "scene/scene.h"

namespace scene
{
  /// Driven by supports or walls and by nothing whose time scale is the true density's (traction,
  /// body force, a throw); slower than `mach` times the wave speed, so that scaling makes the
  /// density larger and never smaller; and for so long that waves cross the bodies ten times and
  /// more. A wave running down a bar is driven by a support too: this is what tells them apart.
  bool quasi_static(const Scene &, double mach);
} // namespace scene
