#include "process_clock.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    fs::path folder_of(const pid_t pid)
    {
      return fs::path("/proc") / std::to_string(pid);
    }

    /// Fields 14 to 17 of stat: user and system time, its own and of the children waited for. They
    /// are counted from the last bracket, for the name in brackets may hold anything.
    double ticks_of(const pid_t pid)
    {
      std::ifstream stream(folder_of(pid) / "stat");
      std::string text;
      std::getline(stream, text, '\0');
      const auto name_end = text.rfind(')');
      if (name_end == std::string::npos)
        return 0.; // it has gone meanwhile
      std::istringstream fields(text.substr(name_end + 1));
      std::string skipped;
      for (int field = 3; field < 14; ++field)
        fields >> skipped;
      double sum = 0., ticks = 0.;
      for (int field = 14; field < 18 && fields >> ticks; ++field)
        sum += ticks;
      return sum;
    }

    void add_children(const pid_t pid, std::vector<pid_t> &family)
    {
      std::error_code gone;
      for (fs::directory_iterator task(folder_of(pid) / "task", gone), end; !gone && task != end;
           task.increment(gone))
      {
        std::ifstream stream(task->path() / "children");
        for (pid_t child = 0; stream >> child;)
          family.push_back(child);
      }
    }
  } // namespace

  double cpu_seconds_with_children(const pid_t pid)
  {
    double ticks = 0.;
    std::vector<pid_t> family{pid};
    for (std::size_t k = 0; k < family.size(); ++k)
    {
      const pid_t member = family[k];
      ticks += ticks_of(member);
      add_children(member, family);
    }
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
} // namespace verify
