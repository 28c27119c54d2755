// Progress and estimated time left, on stderr: one line per 30 s where that is no terminal.
#pragma once

#include <string>

namespace verify
{
  class Progress
  {
  public:
    explicit Progress(int cores);
    /// One more run to do; `wall_s` it took the last time, 0 if it is new.
    void add_run(double wall_s);
    void done(const std::string &name, const std::string &status, double wall_s);
    void show(std::size_t running);

  private:
    double left() const;
    bool terminal;
    int cores, total = 0, finished = 0, unknown = 0;
    double start, last_shown, known_left = 0., spent = 0.;
  };
} // namespace verify
