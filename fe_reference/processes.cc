#include "processes.h"

#include <mpi.h>

namespace fe
{
  void sum_over_processes(std::vector<double> &values)
  {
    if (number_of_processes() > 1)
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE,
                    MPI_SUM, MPI_COMM_WORLD);
  }
  double sum_over_processes(const double value)
  {
    double sum = 0.;
    MPI_Allreduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  }
  double minimum_over_processes(const double value)
  {
    double minimum = 0.;
    MPI_Allreduce(&value, &minimum, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    return minimum;
  }
  int process_number()
  {
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    return number;
  }
  int number_of_processes()
  {
    int count = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    return count;
  }
} // namespace fe
