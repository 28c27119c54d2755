#include "process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "process_clock.h"
#include "record/provenance.h"

namespace verify
{
  namespace
  {
    /// A run may take this many times its limit in wall time: the machine may be busy with others,
    /// or the run may hang.
    constexpr double patience = 5.;
    /// Seconds between two measurements of what a run has started, which opens some files.
    constexpr double look_every = 0.2;

    volatile std::sig_atomic_t interrupt_flag = 0;
    void on_interrupt(int)
    {
      interrupt_flag = 1;
    }

    double now()
    {
      using namespace std::chrono;
      return duration<double>(steady_clock::now().time_since_epoch()).count();
    }

    double seconds(const timeval &t)
    {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    }

    [[noreturn]] void become(const Command &command, int log)
    {
      setpgid(0, 0);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      const int input = open("/dev/null", O_RDONLY);
      dup2(input, 0);
      dup2(log, 1);
      dup2(log, 2);
      for (const auto &[name, value] : command.environment)
        setenv(name.c_str(), value.c_str(), 1);
      std::vector<char *> arguments;
      for (const auto &argument : command.arguments)
        arguments.push_back(const_cast<char *>(argument.c_str()));
      arguments.push_back(nullptr);
      execvp(arguments[0], arguments.data());
      const std::string message =
          command.arguments[0] + " cannot be started: " + std::strerror(errno) + "\n";
      [[maybe_unused]] const auto written = write(2, message.data(), message.size());
      _exit(127);
    }
  } // namespace

  Process::Process(const Command &command)
      : start(now()), limit(command.time_limit_s), cores(command.cores)
  {
    const int log = open(command.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (log < 0)
      throw std::runtime_error(command.log + " cannot be written: " + std::strerror(errno));
    pid = fork();
    if (pid == 0)
      become(command, log);
    close(log);
    if (pid < 0)
      throw std::runtime_error(command.arguments[0] +
                               " cannot be started: " + std::strerror(errno));
    setpgid(pid, pid);
  }

  double Process::wall_s() const
  {
    return now() - start;
  }

  double Process::cpu_s()
  {
    if (wall_s() - tree_measured_at > look_every)
    {
      tree_measured_at = wall_s();
      tree_cpu_s = cpu_seconds_with_children(pid);
    }
    clockid_t clock;
    timespec time{};
    double own = 0.;
    if (clock_getcpuclockid(pid, &clock) == 0 && clock_gettime(clock, &time) == 0)
      own = static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    return std::max(own, tree_cpu_s) / cores;
  }

  std::optional<ProcessResult> Process::poll()
  {
    int status = 0;
    rusage usage{};
    const pid_t found = wait4(pid, &status, WNOHANG, &usage);
    const bool lost = found == -1 && errno == ECHILD; // somebody else has waited for it
    if (found != pid && !lost)
    {
      if (limit > 0. && (cpu_s() > limit || wall_s() > patience * limit) && !timed_out)
        timed_out = wall_s();
      if (timed_out)
        kill(-pid, wall_s() > *timed_out + 5. ? SIGKILL : SIGTERM);
      if (const double seen = record::peak_rss_bytes(std::to_string(pid)); seen > 0.)
        peak_rss_bytes =
            seen; // the last one counts: the first may include the copy of this program
      return {};
    }
    ProcessResult ended;
    ended.wall_s = wall_s();
    ended.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    ended.peak_rss_bytes = 1024. * static_cast<double>(usage.ru_maxrss);
    // Linux starts to count at what this program held when it forked; a child that stays below
    // that is known from the last measurement only.
    if (ended.peak_rss_bytes <= record::peak_rss_bytes() && peak_rss_bytes > 0.)
      ended.peak_rss_bytes = peak_rss_bytes;
    ended.exit_code = lost ? -1 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.timed_out = timed_out.has_value();
    ended.interrupted = interrupted;
    return ended;
  }

  void Process::interrupt()
  {
    interrupted = true;
    kill(-pid, SIGTERM);
  }

  void catch_interrupts()
  {
    struct sigaction action
    {
    };
    action.sa_handler = on_interrupt;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGCHLD, SIG_DFL); // ignored, as some parents leave it, no exit code would arrive
  }

  bool interrupted()
  {
    return interrupt_flag != 0;
  }
} // namespace verify
