// Does a record belong to its run? <run>.run.json keeps what the run left, and a record is only
// reused and judged while it still is that: somebody may have copied another one over it, or have
// changed the scene while it was at work.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jobs.h"
#include "json_text.h"

namespace verify
{
  struct RecordMark
  {
    std::string scene_hash; // as it stands in the record
    std::uintmax_t bytes = 0;
    std::int64_t modified_ns = 0; // since 1970

    bool operator==(const RecordMark &other) const
    {
      return scene_hash == other.scene_hash && bytes == other.bytes &&
             modified_ns == other.modified_ns;
    }
  };

  /// Of the record at `path` as it lies there; empty if there is none that can be read.
  std::optional<RecordMark> mark_record(const std::string &path);

  Json to_json(const RecordMark &);
  /// What a state file says of its record; empty if it says nothing.
  std::optional<RecordMark> mark_in(const Json &state);

  /// What <base>.run.json holds; null if it is absent, broken if it is no JSON.
  Json state_beside(const std::string &base);

  /// Why <base>.h5 is not the record that the run left; "" if it is, or if no state tells.
  std::string replaced_record(const std::string &base);

  /// Why the mark is not that of the scene that the job runs; "" if it is, or if the scene cannot
  /// be read here, as the one of a run that must fail.
  std::string other_scene(const RecordMark &, const Job &);
} // namespace verify
