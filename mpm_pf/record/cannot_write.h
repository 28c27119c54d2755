// What keeps a program under way from writing: a disk that is full, a folder in the way. No fault
// of the scene or of its numbers, so that programs tell it apart and end with an exit code of its
// own.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace record
{
  /// Its text names the file and the system's reason.
  struct CannotWrite : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /// Was it writing that failed? A file that could not get its final name counts as well.
  inline bool is_of_writing(const std::exception &error)
  {
    return dynamic_cast<const CannotWrite *>(&error) ||
           dynamic_cast<const std::filesystem::filesystem_error *>(&error);
  }
} // namespace record
