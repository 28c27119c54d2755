// Child processes: started with their output in a file, measured by wait4, stopped when they run
// too long.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace verify
{
  struct Command
  {
    std::vector<std::string> arguments;                           // arguments[0] is the program
    std::vector<std::pair<std::string, std::string>> environment; // added to ours
    std::string log;                                              // stdout and stderr
    double time_limit_s = 0.; // CPU seconds per core; wall: five times as much
    int cores = 1;
  };

  struct ProcessResult
  {
    int exit_code = 0; // 128 + signal if it was killed
    bool timed_out = false, interrupted = false;
    double wall_s = 0., cpu_s = 0., peak_rss_bytes = 0.;
  };

  /// A running child in its own process group; it dies with this process.
  class Process
  {
  public:
    /// Throws std::runtime_error if it cannot be started or the log cannot be written.
    explicit Process(const Command &);
    /// Empty while it runs. Past its time limit it gets SIGTERM, five seconds later SIGKILL. Exit
    /// code -1: it has gone and nobody knows how.
    std::optional<ProcessResult> poll();
    void interrupt(); // SIGTERM to the group
    double wall_s() const;

    /// Per core; of the child and, measured a few times a second, of all that it started.
    double cpu_s();

  private:
    pid_t pid;
    double start, limit;
    int cores;
    std::optional<double> timed_out; // when it was asked to stop
    bool interrupted = false;
    double tree_cpu_s = 0., tree_measured_at = 0.; // last measurement of them, and when it was
    double peak_rss_bytes = 0.;                    // resident memory, bytes
  };

  /// Turns SIGINT and SIGTERM into a flag.
  void catch_interrupts();
  bool interrupted();
} // namespace verify
