// Where a record comes from: enough to repeat the run and to judge its cost.
#pragma once

#include <map>
#include <string>

namespace record
{
  /// Name -> value: program, version, commit, dirty, compiler, flags, build_type, threads,
  /// host cpu, command line, start time (UTC), library versions. Filled by collect_provenance(); a
  /// solver adds its own: processes, seed of the noise, versions of its libraries.
  using Provenance = std::map<std::string, std::string>;

  /// `program` as in "mpm_pf"; `command` the argv joined; `threads` in use.
  Provenance collect_provenance(const std::string &program, const std::string &command,
                                int threads);

  double wall_seconds(); // monotonic clock
  double cpu_seconds();  // of the whole process, all threads

  /// High-water mark of the resident memory of a live process ("self" or its number) since it was
  /// started (VmHWM of proc(5)); 0 if there is none. That of getrusage is not less than what the
  /// process that forked it held, however small the program is.
  double peak_rss_bytes(const std::string &process = "self");

  double machine_bytes(); // physical memory of this machine
} // namespace record
