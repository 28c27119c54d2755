// Whether what was recorded reaches the end of its run. Of a history that stops early the value at
// the end would be that of another time, a maximum perhaps not the largest, and against a formula,
// which knows no end of its own, nothing would be missing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/reader.h"

namespace verify
{
  /// Throws MissingData if the times of a table end more than their own widest spacing before the
  /// clock of the record's scene, or before the last of the times that the scene lists for this
  /// probe. Runs that may end before their clock (moving walls, a reason for the end in the record)
  /// and records without a scene are not held to it.
  void refuse_early_end(const record::Reader &, const std::string &table,
                        const std::vector<double> &times);

  /// How far a recording may lie from the time that is asked for, as a part of the run's length.
  inline constexpr double one_recording = 1e-3;

  /// The same of a line, outline or snapshot, which is recorded at the end or not: the last of its
  /// times may lie `part` of the end before it.
  void refuse_early_end(const record::Reader &, const std::string &probe,
                        const std::vector<double> &times, double part);

  /// Whether something else than the clock may end the run of a record: walls that move, or a
  /// reason in the record.
  bool may_end_early(const record::Reader &);
} // namespace verify
