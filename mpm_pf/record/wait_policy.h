// How threads wait for each other.
#pragma once

namespace record
{
  /// Threads that spin at a barrier while others hold the cores turn seconds into minutes (27 s for
  /// 2.6 s with two threads on a busy machine), so they shall sleep. The OpenMP library reads
  /// OMP_WAIT_POLICY before main() begins: this sets it and starts the program once more, with the
  /// same `argv`, null at its end. If the caller has chosen a policy it stays and nothing is done,
  /// and likewise if the program cannot be started again.
  void wait_passively(char **argv);
} // namespace record
