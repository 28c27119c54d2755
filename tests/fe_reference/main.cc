// The finite elements need MPI, also for one process.
#include <gtest/gtest.h>
#include <mpi.h>

int main(int argc, char **argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  for (int k = 1; k < argc; ++k) // listing tests must not need a running MPI
    if (std::string(argv[k]).rfind("--gtest_list_tests", 0) == 0)
      return RUN_ALL_TESTS();
  MPI_Init(&argc, &argv);
  const int result = RUN_ALL_TESTS();
  MPI_Finalize();
  return result;
}
