#include "record/atomic_write.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace record
{
  void write_atomically(const std::string &path, const std::string &text)
  {
    const std::string part = path + ".part";
    errno = 0;
    std::ofstream out(part, std::ios::binary);
    out << text;
    out.close(); // what the buffer held may not fit any more
    if (!out)
    {
      const int cause = errno != 0 ? errno : EIO;
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      throw std::filesystem::filesystem_error("cannot write", path,
                                              std::error_code(cause, std::generic_category()));
    }
    std::filesystem::rename(part, path);
  }
} // namespace record
