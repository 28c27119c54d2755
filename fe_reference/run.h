// One run from scene to record: set up, march, observe, finish, whatever the outcome.
#pragma once

#include <functional>
#include <stdexcept>

#include "record/command_line.h"
#include "scene/scene.h"

namespace fe
{
  struct Stopped : std::runtime_error
  {
    explicit Stopped(const std::string &what, const int exit_code = record::numerical_trouble)
        : std::runtime_error(what), exit_code(exit_code)
    {
    }
    int exit_code;
  };

  /// Print what a run would take and stop. Throws Stopped if its first steps met trouble.
  int show_plan(const scene::Scene &, int threads);

  /// Returns the exit code: all_right, numerical_trouble (the last good state is in the record) or
  /// interrupted (a checkpoint is beside the unfinished record). `stop_asked`: by a signal to this
  /// process. Throws scene::BadScene, std::runtime_error for a record that cannot be opened,
  /// Stopped for what goes wrong once the run is under way (a disk that is full).
  int run(const scene::Scene &, const record::CommandLine &,
          const std::function<bool()> &stop_asked);
} // namespace fe
