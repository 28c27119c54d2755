// From a take to its number, curve or outline: reads the records of one case.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "expect.h"
#include "quantity.h"
#include "record/reader.h"

namespace verify
{
  /// The records of one case, opened when first asked for.
  class Records
  {
  public:
    /// `folder` holds <run>.h5; `unusable`: run -> why its record cannot be used.
    Records(std::string folder, std::map<std::string, std::string> unusable);
    /// Throws MissingData naming the run and the cause.
    const record::Reader &open(const std::string &run);
    std::string path(const std::string &run) const;

  private:
    std::string folder;
    std::map<std::string, std::string> unusable;
    std::map<std::string, std::unique_ptr<record::Reader>> readers;
  };

  /// Evaluates a take; `run` replaces the take's own run if it is not empty. Throws MissingData for
  /// what is absent, short or not finite.
  Quantity measure(const Take &, const Constants &, Records &, const std::string &run = "");

  /// A curve of columns: `of` over `abscissa`, cut to `between`, then at one time or reduced to a
  /// number if the take asks so. Columns must hold "time". `by_time`: `between` and `at` mean time.
  Quantity curve_or_number(const Take &, const Constants &, const ColumnData &, bool by_time);
} // namespace verify
