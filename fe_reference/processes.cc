#include "processes.h"

#include <mpi.h>

#include <chrono>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "record/cannot_write.h"

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
  void on_first_process(const std::function<void()> &work)
  {
    std::string failure;
    double kind = 0.; // of the failure: 0 none, 2 one of writing
    if (process_number() == 0)
      try
      {
        work();
      }
      catch (const record::CannotWrite &error)
      {
        kind = 2., failure = error.what();
      }
      catch (const std::exception &error)
      {
        kind = 1., failure = *error.what() ? error.what() : "unknown trouble";
      }
    kind = sum_over_processes(kind); // the others have none
    if (failure.empty())
      failure = "process 0 is in trouble";
    if (kind > 1.)
      throw record::CannotWrite(failure);
    if (kind > 0.)
      throw std::runtime_error(failure);
  }

  void abort_all_processes(const std::string &what, const int exit_code)
  {
    using namespace std::chrono;
    MPI_Request all = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &all);
    const auto longest = steady_clock::now() + seconds(20);
    for (int here = 0; !here; std::this_thread::sleep_for(milliseconds(10)))
    {
      MPI_Test(&all, &here, MPI_STATUS_IGNORE);
      if (!here && steady_clock::now() > longest)
      {
        std::cerr << "fe_reference: process " << process_number() << ": " << what << std::endl;
        MPI_Abort(MPI_COMM_WORLD, exit_code);
      }
    }
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
