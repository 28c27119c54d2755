// Text files that are either whole or not there: campaigns and kernels are read by programs, and
// half a JSON file under its final name is worse than none.
#pragma once

#include <string>

namespace record
{
  /// Writes `text` to <path>.part and renames that to `path` once every byte is with the system; an
  /// older file stays until then. Throws std::filesystem::filesystem_error with path and cause
  /// (a full disk shows in the flush only), and leaves no .part behind.
  void write_atomically(const std::string &path, const std::string &text);
} // namespace record
