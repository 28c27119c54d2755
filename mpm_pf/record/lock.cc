#include "record/lock.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace record
{
  namespace
  {
    /// Is the file that was opened still the one of that name? Whoever held it before may have
    /// removed it in between, and a third made another.
    bool still_there(const int descriptor, const std::string &path)
    {
      struct stat opened
      {
      }, named{};
      return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
             opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
    }

    std::string holder(const int descriptor)
    {
      char text[32] = {};
      const bool written = pread(descriptor, text, sizeof text - 1, 0) > 0;
      const long pid = written ? std::strtol(text, nullptr, 10) : 0;
      return pid > 0 ? "process " + std::to_string(pid) : "another process";
    }

    void sign(const int descriptor)
    {
      const std::string pid = std::to_string(getpid()) + "\n";
      // Whether this succeeds or not, the lock holds: the number is only for messages.
      if (ftruncate(descriptor, 0) == 0) [[maybe_unused]]
        const auto written = pwrite(descriptor, pid.data(), pid.size(), 0);
    }
  } // namespace

  Lock::Lock(const std::string &file, const std::string &what, const std::string &remedy)
      : path(file), descriptor(-1)
  {
    while (true)
    {
      descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (descriptor < 0)
        throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
      const bool taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
      if (taken)
      {
        const std::string by = holder(descriptor);
        close(descriptor);
        throw std::runtime_error(what + " is in use by " + by + ": " + remedy);
      }
      if (still_there(descriptor, path))
        break;
      close(descriptor);
    }
    sign(descriptor);
  }

  Lock::Lock(Lock &&other) noexcept
      : path(std::move(other.path)), descriptor(std::exchange(other.descriptor, -1))
  {
  }

  Lock::~Lock()
  {
    if (descriptor < 0)
      return;
    unlink(path.c_str()); // while it is held, so that nobody else's is removed
    close(descriptor);
  }
} // namespace record
