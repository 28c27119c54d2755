// Sums and agreements over the processes of one run (MPI); with one process they cost nothing.
#pragma once

#include <vector>

namespace fe
{
  /// Sum over processes, in place or returned; every process must call it.
  void sum_over_processes(std::vector<double> &);
  double sum_over_processes(double);
  double minimum_over_processes(double);

  int process_number(); // 0 is the one that reads, writes and speaks
  int number_of_processes();
} // namespace fe
