#include "reaction_window.h"

#include <algorithm>
#include <cmath>

ReactionWindow::ReactionWindow(const ReactionSampling &sampling)
    : times(sampling.times), half(sampling.half_width), end(sampling.end),
      tolerance(1e-9 * sampling.end)
{
}

std::vector<double> ReactionWindow::events() const
{
  std::vector<double> all;
  for (const double t : times)
  {
    all.push_back(std::max(0., t - half));
    all.push_back(t);
    all.push_back(std::min(end, t + half));
  }
  return all;
}

const ReactionWindow::Reading *ReactionWindow::reading_at(const double time) const
{
  const auto near = std::find_if(readings.begin(), readings.end(),
                                 [&](const Reading &reading)
                                 { return std::abs(reading.time - time) <= tolerance; });
  return near == readings.end() ? nullptr : &*near;
}

std::optional<ReactionWindow::Mean> ReactionWindow::mean(const std::size_t sample) const
{
  const Reading *from = reading_at(begin_of(sample));
  const Reading *to = reading_at(std::min(end, times[sample] + half));
  if (!from || !to)
    return {};
  return Mean{(from->time + to->time) / 2, (to->impulse - from->impulse) / (to->time - from->time)};
}

void ReactionWindow::end_early(const double time)
{
  end = time;
  const std::size_t asked = times.size();
  while (times.size() > returned && times.back() > end - half / 4)
    times.pop_back();
  ended_early = times.size() < asked;
  if (ended_early)
    times.push_back(end);
}

double ReactionWindow::begin_of(const std::size_t sample) const
{
  // Half a window before an early end there is no reading; at the sample before it there is one.
  const bool unforeseen = ended_early && sample > 0 && sample + 1 == times.size();
  return unforeseen ? times[sample - 1] : std::max(0., times[sample] - half);
}

std::vector<ReactionRow> ReactionWindow::add(const double time, const scene::Point &impulse,
                                             const scene::Point &displacement)
{
  readings.push_back({time, impulse, displacement});
  std::vector<ReactionRow> rows;
  while (returned < times.size())
  {
    const std::size_t k = returned;
    const Reading *here = reading_at(times[k]);
    const auto own = mean(k);
    if (!here || !own)
      break;
    ReactionRow row{times[k], own->force, here->displacement};
    if (std::abs(own->centre - times[k]) > tolerance && times.size() > 1)
    {
      const auto neighbour = mean(k == 0 ? 1 : k - 1);
      if (!neighbour)
        break; // the first row waits for the second
      // An early end within half a window of the first sample: both have the same window.
      const double apart = neighbour->centre - own->centre;
      if (std::abs(apart) > tolerance)
        row.force += (neighbour->force - own->force) * (times[k] - own->centre) / apart;
    }
    rows.push_back(row);
    ++returned;
  }
  // The row before the next one to return may still be needed to extrapolate it.
  const double oldest = returned < 2 ? 0. : times[returned - 2] - 1.01 * half;
  readings.erase(std::remove_if(readings.begin(), readings.end(),
                                [&](const Reading &reading) { return reading.time < oldest; }),
                 readings.end());
  return rows;
}

std::vector<double> ReactionWindow::state() const
{
  std::vector<double> flat{static_cast<double>(returned)};
  for (const Reading &reading : readings)
    flat.insert(flat.end(), {reading.time, reading.impulse[0], reading.impulse[1],
                             reading.displacement[0], reading.displacement[1]});
  return flat;
}

void ReactionWindow::restore(const std::vector<double> &flat)
{
  returned = static_cast<std::size_t>(flat.at(0));
  readings.clear();
  for (std::size_t i = 1; i + 5 <= flat.size(); i += 5)
    readings.push_back({flat[i], {flat[i + 1], flat[i + 2]}, {flat[i + 3], flat[i + 4]}});
}
