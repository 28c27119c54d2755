// One writer at a time: a file that a process holds (flock) while it writes what lies beside it.
//
// The system gives it back when the process ends, however that ends, so that a lock file left
// behind by a kill bars nobody. Only those who ask for the lock are kept out; whoever reads a
// record while it grows may do so.
#pragma once

#include <string>

namespace record
{
  class Lock
  {
  public:
    /// Takes `path`, a file of its own that is made for it and removed with it. Throws
    /// std::runtime_error "`what` is in use by process PID" and `remedy` if somebody holds it, or
    /// with the system's reason if it cannot be made. Where the file system knows no locks there
    /// is none.
    Lock(const std::string &path, const std::string &what, const std::string &remedy);
    Lock(Lock &&) noexcept;
    Lock(const Lock &) = delete;
    Lock &operator=(const Lock &) = delete;
    Lock &operator=(Lock &&) = delete;
    ~Lock();

  private:
    std::string path;
    int descriptor; // -1: given away
  };
} // namespace record
