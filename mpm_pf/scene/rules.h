// What must hold between keys, in one readable list.
#pragma once

#include "scene/build.h"

namespace scene
{
  /// Applies every rule to what was read; each that is broken becomes one complaint, with the
  /// reason and the remedy. Rules about values that already have a complaint are skipped.
  void check_rules(const Draft &, Complaints &);
} // namespace scene
