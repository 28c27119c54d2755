// From files to one tree: toml11 parses, `include` and overrides are merged here.
#pragma once

#include <string>
#include <vector>

#include "scene/error_list.h"
#include "scene/value.h"

namespace scene
{
  /// The tree of `path` with its includes and overrides merged. Tables merge key by key; lists of
  /// tables merge by label (see label()), new labels are appended; everything else is replaced, and
  /// of keys that exclude each other (keys.h) the later one wins. Unreadable files, syntax errors,
  /// circles of includes and overrides of nothing become errors.
  Value load_document(const std::string &path, const std::vector<std::string> &overrides,
                      ErrorList &);

  /// `message`, then file, line, and the line with `at` underlined.
  std::string underlined(const Value &at, const std::string &message);
} // namespace scene
