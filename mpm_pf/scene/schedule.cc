#include "scene/schedule.h"

#include <algorithm>
#include <cmath>

namespace scene
{
  namespace
  {
    constexpr int default_samples = 200;

    bool is_history(const Probe &probe)
    {
      return !std::holds_alternative<LineProbe>(probe.kind) &&
             !std::holds_alternative<OutlineProbe>(probe.kind) &&
             !std::holds_alternative<SnapshotProbe>(probe.kind);
    }
  } // namespace

  double sample_interval(const Probe &probe, const double end)
  {
    return probe.every ? *probe.every : end / default_samples;
  }

  std::vector<double> sample_times(const Probe &probe, const double end)
  {
    if (!probe.compressions.empty())
      return {};
    std::vector<double> times;
    if (!probe.times.empty())
    {
      for (const double t : probe.times)
        if (t >= 0. && t <= end * (1. + rounding_of_times) && (times.empty() || times.back() < end))
          times.push_back(std::min(t, end));
    }
    else if (!probe.every && !is_history(probe))
      times = {end};
    else
    {
      const double interval = sample_interval(probe, end);
      const long count = std::lround(std::floor(end / interval * (1. + 1e-12)));
      for (long n = 0; n <= count; ++n)
        times.push_back(static_cast<double>(n) * interval);
      if (times.back() < end * (1. - 1e-12))
        times.push_back(end);
    }
    std::sort(times.begin(), times.end());
    return times;
  }
} // namespace scene
