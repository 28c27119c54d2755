#include "curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace verify
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    double extent(const std::vector<double> &x)
    {
      if (x.empty())
        return 0.;
      const auto [low, high] = std::minmax_element(x.begin(), x.end());
      return *high - *low;
    }

    Curve part(const Curve &curve, std::size_t first, std::size_t last)
    {
      const auto cut = [&](const std::vector<double> &v)
      { return std::vector<double>(v.begin() + first, v.begin() + last); };
      return {cut(curve.x), cut(curve.y), cut(curve.t)};
    }

    /// Finite samples of one branch that the other covers too, over all its finite samples.
    void count_cover(const Curve &samples, const Curve &other, std::size_t &finite,
                     std::size_t &covered)
    {
      for (std::size_t i = 0; i < samples.x.size(); ++i)
        if (std::isfinite(samples.y[i]))
        {
          ++finite;
          covered += std::isfinite(interpolate(other, samples.x[i]));
        }
    }

    void refuse_infinite(const Curve &curve)
    {
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isinf(curve.y[i]) || !std::isfinite(curve.x[i]))
          throw MissingData(
              fmt::format("value {} at abscissa {} is not finite", curve.y[i], curve.x[i]));
    }

    /// The times must reach both ends of the stretch, to their own widest spacing.
    void refuse_short(const std::vector<double> &times, const double from, const double to)
    {
      if (times.empty())
        return;
      double spacing = 0.;
      for (std::size_t i = 1; i < times.size(); ++i)
        spacing = std::max(spacing, std::abs(times[i] - times[i - 1]));
      spacing *= 1. + 1e-9;
      const auto [first, last] = std::minmax_element(times.begin(), times.end());
      const bool asked_once = times.size() == 1 && *first >= from && *first <= to;
      if (!asked_once && (*first > from + spacing || *last < to - spacing))
        throw MissingData(fmt::format("short: recorded from time {} to {}, wanted from {} to {}",
                                      *first, *last, from, to));
    }

    Curve finite_part(const Curve &curve)
    {
      Curve result;
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.y[i]) && std::isfinite(curve.x[i]))
        {
          result.x.push_back(curve.x[i]);
          result.y.push_back(curve.y[i]);
          result.t.push_back(curve.t[i]);
        }
      return result;
    }

    double integral(const Curve &c)
    {
      double sum = 0.;
      for (std::size_t i = 1; i < c.x.size(); ++i)
        sum += 0.5 * (c.y[i] + c.y[i - 1]) * (c.x[i] - c.x[i - 1]);
      return sum;
    }

    /// Straight line of least squares: value at the mean abscissa, slope, rms of what is left.
    struct Line
    {
      double slope = 0., rms = 0.;
    };
    Line least_squares(const Curve &c)
    {
      const double n = static_cast<double>(c.x.size());
      const double mx = std::accumulate(c.x.begin(), c.x.end(), 0.) / n;
      const double my = std::accumulate(c.y.begin(), c.y.end(), 0.) / n;
      double xx = 0., xy = 0., rest = 0.;
      for (std::size_t i = 0; i < c.x.size(); ++i)
      {
        xx += (c.x[i] - mx) * (c.x[i] - mx);
        xy += (c.x[i] - mx) * (c.y[i] - my);
      }
      const double slope = xx > 0. ? xy / xx : 0.;
      for (std::size_t i = 0; i < c.x.size(); ++i)
        rest += std::pow(c.y[i] - my - slope * (c.x[i] - mx), 2);
      return {slope, std::sqrt(rest / n)};
    }
  } // namespace

  double interpolate(const Curve &c, const double x)
  {
    if (c.x.empty())
      return nan;
    const double slack = 1e-9 * extent(c.x) + 1e-14 * std::abs(x);
    const bool rising = c.x.back() >= c.x.front();
    const auto before = [&](double a, double b) { return rising ? a < b : a > b; };
    const std::size_t i = std::lower_bound(c.x.begin(), c.x.end(), x, before) - c.x.begin();
    if (i < c.x.size() && std::abs(c.x[i] - x) <= slack)
      return c.y[i];
    if (i > 0 && std::abs(c.x[i - 1] - x) <= slack)
      return c.y[i - 1];
    if (i == 0 || i == c.x.size())
      return nan;
    const double s = (x - c.x[i - 1]) / (c.x[i] - c.x[i - 1]);
    return (1. - s) * c.y[i - 1] + s * c.y[i];
  }

  std::vector<Curve> branches(const Curve &curve)
  {
    std::vector<Curve> result;
    const std::size_t n = curve.x.size();
    const double noise = 1e-3 * extent(curve.x);
    std::size_t first = 0, furthest = 0;
    int direction = 0;
    for (std::size_t i = 1; i < n; ++i)
    {
      const double step = curve.x[i] - curve.x[furthest];
      if (direction == 0 && std::abs(step) <= noise)
        continue; // it has not left its start yet
      if (direction == 0)
        direction = step > 0. ? 1 : -1;
      if (step * direction >= 0.)
        furthest = i;
      else if (std::abs(step) > noise)
      {
        result.push_back(part(curve, first, furthest + 1));
        first = furthest;
        direction = -direction;
        furthest = i;
      }
    }
    if (n > 0)
      result.push_back(part(curve, first, n));
    // what is left of noise inside a branch would break the search for neighbours: keep the running
    // extreme
    for (auto &branch : result)
    {
      const bool rising = branch.x.back() >= branch.x.front();
      for (std::size_t i = 1; i < branch.x.size(); ++i)
        branch.x[i] = rising ? std::max(branch.x[i], branch.x[i - 1])
                             : std::min(branch.x[i], branch.x[i - 1]);
    }
    return result;
  }

  CommonSamples common_samples(const Curve &a, const Curve &b, const double coverage)
  {
    refuse_infinite(a);
    refuse_infinite(b);
    const auto in_a = branches(a), in_b = branches(b);
    if (in_a.empty() || in_b.empty())
      throw MissingData("no samples");
    if (in_a.size() != in_b.size())
      throw MissingData(fmt::format("the abscissa turns round {} times in one and {} times in the "
                                    "other",
                                    in_a.size() - 1, in_b.size() - 1));
    CommonSamples common;
    std::size_t finite_a = 0, covered_a = 0, finite_b = 0, covered_b = 0;
    for (std::size_t k = 0; k < in_a.size(); ++k)
    {
      count_cover(in_a[k], in_b[k], finite_a, covered_a);
      count_cover(in_b[k], in_a[k], finite_b, covered_b);
      common.start.push_back(common.x.size());
      for (std::size_t i = 0; i < in_b[k].x.size(); ++i)
      {
        const double value = interpolate(in_a[k], in_b[k].x[i]);
        if (!std::isfinite(value) || !std::isfinite(in_b[k].y[i]))
          continue;
        common.x.push_back(in_b[k].x[i]);
        common.a.push_back(value);
        common.b.push_back(in_b[k].y[i]);
      }
    }
    if (common.x.empty())
      throw MissingData("nowhere do both have a value");
    if (static_cast<double>(covered_a) < coverage * static_cast<double>(finite_a) ||
        static_cast<double>(covered_b) < coverage * static_cast<double>(finite_b))
      throw MissingData(
          fmt::format("short: {} of {} and {} of {} samples are covered by the other; "
                      "wanted {:.0f} %",
                      covered_a, finite_a, covered_b, finite_b, 100. * coverage));
    return common;
  }

  std::vector<double> weights(const CommonSamples &common)
  {
    const std::size_t n = common.x.size();
    std::vector<double> weight(n, 0.);
    for (std::size_t k = 0; k < common.start.size(); ++k)
    {
      const std::size_t end = k + 1 < common.start.size() ? common.start[k + 1] : n;
      for (std::size_t i = common.start[k] + 1; i < end; ++i)
      {
        const double half = 0.5 * std::abs(common.x[i] - common.x[i - 1]);
        weight[i - 1] += half;
        weight[i] += half;
      }
    }
    if (std::accumulate(weight.begin(), weight.end(), 0.) <= 0.)
      weight.assign(n, 1.);
    return weight;
  }

  Curve between(const Curve &curve, const bool by_time, const double from, const double to)
  {
    Curve result;
    const auto &key = by_time ? curve.t : curve.x;
    const double slack = 1e-9 * extent(key);
    if (by_time)
      refuse_short(key, from, to);
    for (std::size_t i = 0; i < key.size(); ++i)
      if (key[i] >= from - slack && key[i] <= to + slack)
      {
        result.x.push_back(curve.x[i]);
        result.y.push_back(curve.y[i]);
        result.t.push_back(curve.t[i]);
      }
    return result;
  }

  double reduce(const Curve &whole, const std::string &how)
  {
    refuse_infinite(whole); // NaN is where a line leaves the body
    const Curve c = finite_part(whole);
    if (c.y.empty())
      throw MissingData("no finite sample");
    const auto [low, high] = std::minmax_element(c.y.begin(), c.y.end());
    const double span = c.x.back() - c.x.front();
    if (how == "max")
      return *high;
    if (how == "min")
      return *low;
    if (how == "max_abs")
      return std::max(std::abs(*low), std::abs(*high));
    if (how == "range")
      return *high - *low;
    if (how == "first")
      return c.y.front();
    if (how == "last")
      return c.y.back();
    if (how == "slope")
      return least_squares(c).slope;
    if (how == "ripple")
      return least_squares(c).rms;
    if (how == "integral")
      return integral(c);
    Curve taken = c;
    if (how == "rms")
      for (auto &y : taken.y)
        y *= y;
    const double mean = span != 0.
                            ? integral(taken) / span
                            : std::accumulate(taken.y.begin(), taken.y.end(), 0.) / taken.y.size();
    return how == "rms" ? std::sqrt(std::max(0., mean)) : mean;
  }
} // namespace verify
