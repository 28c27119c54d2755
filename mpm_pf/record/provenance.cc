#include "record/provenance.h"

#include <chrono>
#include <ctime>
#include <fstream>

#include <Eigen/Core>
#include <hdf5.h>
#include <unistd.h>

#include "commit.h"

namespace record
{
  namespace
  {
    std::string utc_now()
    {
      const std::time_t now = std::time(nullptr);
      std::tm utc{};
      gmtime_r(&now, &utc);
      char text[32];
      std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
      return text;
    }

    std::string cpu_model()
    {
      std::ifstream info("/proc/cpuinfo");
      for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
          return line.substr(line.find(": ") + 2);
      return "unknown";
    }

    std::string hdf5_version()
    {
      unsigned major = 0, minor = 0, release = 0;
      H5get_libversion(&major, &minor, &release);
      return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
    }

    std::string eigen_version()
    {
      return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
             std::to_string(EIGEN_MINOR_VERSION);
    }
  } // namespace

  Provenance collect_provenance(const std::string &program, const std::string &command,
                                const int threads)
  {
    return {{"program", program},
            {"version", MPM_PF_VERSION},
            {"commit", MPM_PF_COMMIT},
            {"dirty", MPM_PF_DIRTY},
            {"compiler", MPM_PF_COMPILER},
            {"flags", MPM_PF_FLAGS},
            {"build_type", MPM_PF_BUILD_TYPE},
            {"threads", std::to_string(threads)},
            {"cpu", cpu_model()},
            {"command", command},
            {"start", utc_now()},
            {"hdf5", hdf5_version()},
            {"eigen", eigen_version()}};
  }

  double wall_seconds()
  {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
  }

  double cpu_seconds()
  {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  }

  double peak_rss_bytes(const std::string &process)
  {
    std::ifstream stream("/proc/" + process + "/status");
    for (std::string name, rest; stream >> name && std::getline(stream, rest);)
      if (name == "VmHWM:")
        return 1024. * std::stod(rest); // Linux counts in KiB
    return 0.;
  }

  double machine_bytes()
  {
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  }
} // namespace record
