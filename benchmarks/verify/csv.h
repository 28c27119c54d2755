// A reference table in the case folder: a header line with the names, commas, lines that start with
// # are comments.
#pragma once

#include <string>

#include "formula.h"

namespace verify
{
  /// Throws MissingReference if the file is absent, BadInput naming file and line if a heading is
  /// no name of expressions or stands twice, or a row is not as many numbers.
  ColumnData read_csv(const std::string &path);
} // namespace verify
