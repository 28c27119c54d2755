#include "scene/speed.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scene
{
  namespace
  {
    struct Interval
    {
      double begin, end;
      Point from, to;
      double speed() const
      {
        const double found = (to - from).norm() / (end - begin);
        return found > 0. ? found : 0.; // what is no number is no speed
      }
    };

    // Halves an interval towards its faster side until that brings nothing any more.
    double steepest(const std::function<Point(double)> &at, Interval now, const double shortest)
    {
      constexpr int patience = 3;
      double largest = now.speed();
      for (int in_vain = 0; in_vain < patience && now.end - now.begin > shortest;)
      {
        const double middle = 0.5 * (now.begin + now.end);
        const Point there = at(middle);
        const Interval first{now.begin, middle, now.from, there},
            second{middle, now.end, there, now.to};
        now = first.speed() > second.speed() ? first : second;
        in_vain = now.speed() > 1.001 * largest ? 0 : in_vain + 1;
        largest = std::max(largest, now.speed());
      }
      return largest;
    }
  } // namespace

  std::vector<double> uneven_times(const double end, const int count)
  {
    constexpr double golden = 0.6180339887498949;
    std::vector<double> times;
    for (int k = 1; k < count; ++k)
      times.push_back(end / count * (k + 0.5 * std::fmod(k * golden, 1.) - 0.25));
    times.push_back(end);
    return times;
  }

  double largest_speed(const std::function<Point(double)> &at, const double end)
  {
    constexpr int samples = 400;
    constexpr std::size_t followed = 8;
    std::vector<Interval> list;
    double last = 0.;
    Point from = at(0.);
    for (const double t : uneven_times(end, samples))
    {
      const Point to = at(t);
      list.push_back({last, t, from, to});
      last = t, from = to;
    }
    std::partial_sort(list.begin(), list.begin() + followed, list.end(),
                      [](const Interval &a, const Interval &b) { return a.speed() > b.speed(); });
    double largest = 0.;
    for (std::size_t k = 0; k < followed; ++k)
      largest = std::max(largest, steepest(at, list[k], 1e-6 * end));
    return largest;
  }
} // namespace scene
