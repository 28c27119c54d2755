// Progress and estimated time left, on a stream that the program gives (libraries never print on
// their own): one line rewritten in place on a terminal, one line per 30 s where it is none.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace record
{
  class Progress
  {
  public:
    enum class Style
    {
      terminal, // rewrite one line, at most five times a second
      log,      // a line per 30 s
      quiet     // nothing
    };

    /// Style for stderr: quiet if asked for, else by whether it is a terminal.
    static Style style_of_stderr(bool quiet);

    /// The simulated time to go; begin > 0 for a resumed run.
    struct Range
    {
      double begin = 0., end = 0.;
    };

    /// `what` opens every line, as in "mpm_pf shear"; the rate counts from the range's begin. The
    /// time left is predicted from the pace of the last one to two `window_s`: a crystal that meets
    /// a wall goes on far more slowly.
    Progress(std::ostream &, Style, std::string what, const Range &, double window_s = 30.);

    /// The run is now thought to last until `end` (walls may end it sooner than its clock).
    void set_end(double end);
    /// Say where the run is; cheap when it is not yet time for a line. `detail` is appended, as in
    /// "step 1200".
    void update(double time, const std::string &detail = "");
    /// Last line: wall time taken and `outcome`.
    void finish(const std::string &outcome = "done");

    /// "1 h 02 min", "3 min 20 s", "12 s", "0.4 s".
    static std::string duration(double seconds);

  private:
    using Clock = std::chrono::steady_clock;
    struct Mark
    {
      Clock::time_point at;
      double time;
    };

    std::ostream *out;
    Style style;
    std::string what;
    double begin, end, window_s;
    Clock::time_point start = Clock::now(), last = start;
    Mark earlier{start, begin}, later = earlier; // at least a window apart
    std::size_t length = 0;                      // of the line on the terminal, to wipe it

    double seconds_left(double time);
    void write_line(const std::string &line);
  };
} // namespace record
