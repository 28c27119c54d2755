#include "record/wait_policy.h"

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace record
{
  void wait_passively(char **argv)
  {
    constexpr auto policy = "OMP_WAIT_POLICY";
    if (std::getenv(policy) != nullptr)
      return;
    std::error_code failure; // by its own path: as /proc/self/exe it would be called "exe"
    const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure || setenv(policy, "passive", 0) != 0)
      return;
    execv(program.c_str(), argv);
  }
} // namespace record
