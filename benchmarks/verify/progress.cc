#include "progress.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "record/provenance.h"

namespace verify
{
  Progress::Progress(const int c)
      : terminal(isatty(2) != 0), cores(std::max(1, c)), start(record::wall_seconds()),
        last_shown(start)
  {
  }

  void Progress::add_run(const double wall_s)
  {
    ++total;
    known_left += wall_s;
    unknown += wall_s > 0. ? 0 : 1;
  }

  double Progress::left() const
  {
    // new runs are taken to be like those that are finished
    const double typical = finished > 0 ? spent / finished : 0.;
    const double expected = std::max(known_left - spent, 0.) + unknown * typical;
    const double rest = finished > 0 && unknown > 0 ? typical * (total - finished) : expected;
    return rest / cores;
  }

  void Progress::done(const std::string &name, const std::string &status, const double wall_s)
  {
    ++finished;
    spent += wall_s;
    const double elapsed = record::wall_seconds() - start;
    fmt::print(stderr, "{}[{:6.0f} s] {:3}/{} {}: {} ({:.1f} s)\n", terminal ? "\r\033[K" : "",
               elapsed, finished, total, name, status, wall_s);
  }

  void Progress::show(const std::size_t running)
  {
    const double now = record::wall_seconds();
    if (total == 0 || now - last_shown < (terminal ? 0.5 : 30.))
      return;
    last_shown = now;
    const std::string rest =
        finished > 0 || known_left > 0. ? fmt::format("about {:.0f} s left", left()) : "";
    fmt::print(stderr, "{}[{:6.0f} s] {}/{} done, {} running {}{}", terminal ? "\r\033[K" : "",
               now - start, finished, total, running, rest, terminal ? "" : "\n");
    std::fflush(stderr);
  }
} // namespace verify
