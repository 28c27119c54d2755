// Sums and agreements over the processes of one run (MPI); with one process they cost nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace fe
{
  /// Sum over processes, in place or returned; every process must call it.
  void sum_over_processes(std::vector<double> &);
  double sum_over_processes(double);
  double minimum_over_processes(double);

  /// What process 0 does alone while the others wait, such as writing. If it throws, all throw
  /// std::runtime_error (record::CannotWrite if it did), process 0 with the same text. Every
  /// process must call it.
  void on_first_process(const std::function<void()> &work);

  /// After a failure: waits until all processes have one, 20 s at most, since one that goes its own
  /// way leaves the others waiting for it for ever. After that it says `what` and ends them all.
  void abort_all_processes(const std::string &what, int exit_code);

  int process_number(); // 0 is the one that reads, writes and speaks
  int number_of_processes();
} // namespace fe
