// CPU time of a process and of all that it started. mpirun computes nothing itself: its ranks,
// which it may put into process groups of their own, hold the time.
#pragma once

#include <sys/types.h>

namespace verify
{
  /// Seconds of CPU of a live process and its descendants, those included that have ended and were
  /// waited for (Linux: stat and task/*/children of proc(5); in steps of a clock tick). 0 if there
  /// is no such process.
  double cpu_seconds_with_children(pid_t);
} // namespace verify
