#include "record/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include <unistd.h>

namespace record
{
  namespace
  {
    std::string printed(const char *format, const double a, const double b = 0.)
    {
      char text[64];
      std::snprintf(text, sizeof text, format, a, b);
      return text;
    }

    double seconds_since(const std::chrono::steady_clock::time_point then)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    }
  } // namespace

  Progress::Style Progress::style_of_stderr(const bool quiet)
  {
    return quiet ? Style::quiet : isatty(STDERR_FILENO) != 0 ? Style::terminal : Style::log;
  }

  Progress::Progress(std::ostream &out, const Style style, std::string what, const Range &range,
                     const double window_s)
      : out(&out), style(style), what(std::move(what)), begin(range.begin), end(range.end),
        window_s(window_s)
  {
  }

  std::string Progress::duration(const double seconds)
  {
    if (seconds < 9.95)
      return printed("%.1f s", seconds);
    const double whole = std::round(seconds);
    if (whole < 60.)
      return printed("%.0f s", whole);
    if (whole < 3600.)
      return printed("%.0f min %02.0f s", std::floor(whole / 60.), std::fmod(whole, 60.));
    const double minutes = std::round(whole / 60.);
    return printed("%.0f h %02.0f min", std::floor(minutes / 60.), std::fmod(minutes, 60.));
  }

  void Progress::set_end(const double new_end)
  {
    end = new_end;
  }

  void Progress::update(const double time, const std::string &detail)
  {
    const double interval = style == Style::terminal ? 0.2 : 30.;
    if (style == Style::quiet || seconds_since(last) < interval)
      return;
    last = Clock::now();
    const double fraction = end > begin ? (time - begin) / (end - begin) : 1.;
    std::string line = what + printed(": %5.1f %%  t = %g", 100. * fraction, time);
    if (!detail.empty())
      line += "  " + detail;
    if (const double left = seconds_left(time); std::isfinite(left))
      line += "  left " + duration(left);
    write_line(line);
  }

  double Progress::seconds_left(const double time)
  {
    if (seconds_since(later.at) >= window_s)
    {
      earlier = later;
      later = {Clock::now(), time};
    }
    return seconds_since(earlier.at) * (end - time) / (time - earlier.time);
  }

  void Progress::write_line(const std::string &line)
  {
    if (style == Style::terminal)
    {
      *out << '\r' << line << std::string(length - std::min(length, line.size()), ' ');
      length = line.size();
    }
    else
      *out << line << '\n';
    out->flush();
  }

  void Progress::finish(const std::string &outcome)
  {
    if (style == Style::quiet)
      return;
    write_line(what + ": " + outcome + " in " + duration(seconds_since(start)));
    if (style == Style::terminal)
      *out << '\n' << std::flush;
  }
} // namespace record
