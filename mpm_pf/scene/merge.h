// How one tree is laid over another: includes and overrides.
#pragma once

#include "scene/error_list.h"
#include "scene/value.h"

namespace scene
{
  /// Lays `over` on `base`. Tables merge key by key, lists of tables by label, new labels are
  /// appended, the rest is replaced; of keys that exclude each other the later one wins.
  void merge(Value &base, const Value &over);

  /// The same for "--set": here an entry of a list of tables is addressed by its label,
  /// support.top.displacement or body.1.size, and must exist.
  void override_with(Value &base, const Value &over, ErrorList &);

  /// "--set mpm.mach=": takes a key of a section away, so that its default (or a preset) holds.
  /// The key must be one of the language; it need not be written.
  void remove_key(Value &base, const std::string &path, ErrorList &);
} // namespace scene
