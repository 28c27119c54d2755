#include "grids.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "quantity.h"

namespace verify
{
  namespace
  {
    /// p of e23/(r23^p - 1) = r12^p e12/(r12^p - 1) for e23/e12 = ratio; the left side over the
    /// right falls in p.
    double solve_order(const double ratio, const double r12, const double r23)
    {
      const auto excess = [&](double p)
      { return ratio * (std::pow(r12, p) - 1.) - (std::pow(r23, p) - 1.) * std::pow(r12, p); };
      double low = 1e-6, high = 20.;
      if (excess(low) <= 0.)
        return low;
      for (int i = 0; i < 200 && high - low > 1e-13; ++i)
      {
        const double middle = 0.5 * (low + high);
        (excess(middle) > 0. ? low : high) = middle;
      }
      return 0.5 * (low + high);
    }
  } // namespace

  std::vector<std::size_t> fine_to_coarse(const std::vector<double> &h)
  {
    std::vector<std::size_t> index(h.size());
    std::iota(index.begin(), index.end(), 0);
    std::sort(index.begin(), index.end(), [&](auto a, auto b) { return h[a] < h[b]; });
    return index;
  }

  GridUncertainty grid_uncertainty(const ThreeGrids &grids, const double order_at_most)
  {
    const auto [e12, e23, r12, r23, size_ratio, spread] = grids;
    GridUncertainty result;
    if (e12 == 0. && e23 == 0.)
    {
      result.monotone = true;
      result.order = order_at_most;
      return result;
    }
    // differences that grow, stay or change sign towards the fine side carry no order
    const double ratio = e12 == 0. ? -1. : e23 / e12;
    const double order = ratio > 0. ? solve_order(ratio, r12, r23) : 0.;
    if (order < 0.1)
    {
      result.uncertainty = safety * spread;
      return result;
    }
    result.monotone = true;
    result.order = order;
    const double believed = std::min(order, order_at_most);
    result.uncertainty =
        safety * std::abs(e12) / (std::pow(r12, believed) - 1.) * std::pow(size_ratio, believed);
    // An order far below one says that the grids are not yet in the asymptotic range; extrapolating
    // with it multiplies their differences without bound.
    if (order < 0.95)
      result.uncertainty = std::min(result.uncertainty, safety * std::max(spread, std::abs(e12)));
    return result;
  }

  GridUncertainty grid_uncertainty(const std::vector<double> &h, const std::vector<double> &f,
                                   const std::size_t wanted, const double order_at_most)
  {
    const auto difference = [&](std::size_t i, std::size_t j) { return f[i] - f[j]; };
    auto result = grid_uncertainty(h, difference, wanted, order_at_most);
    const auto k = fine_to_coarse(h);
    if (result.monotone)
      result.limit =
          f[k[0]] + (f[k[0]] - f[k[1]]) /
                        (std::pow(h[k[1]] / h[k[0]], std::min(result.order, order_at_most)) - 1.);
    return result;
  }

  double observed_order(const std::vector<double> &h, const std::vector<double> &error)
  {
    double mx = 0., my = 0., xx = 0., xy = 0.;
    for (std::size_t i = 0; i < h.size(); ++i)
    {
      if (!(error[i] > 0.) || !std::isfinite(error[i]))
        throw MissingData(fmt::format("no order: the error at h = {} is {}", h[i], error[i]));
      mx += std::log(h[i]) / static_cast<double>(h.size());
      my += std::log(error[i]) / static_cast<double>(h.size());
    }
    for (std::size_t i = 0; i < h.size(); ++i)
    {
      xx += std::pow(std::log(h[i]) - mx, 2);
      xy += (std::log(h[i]) - mx) * (std::log(error[i]) - my);
    }
    if (!(xx > 0.))
      throw MissingData("no order: all runs have the same h");
    return xy / xx;
  }

  std::string GridUncertainty::text() const
  {
    if (!monotone)
      return fmt::format("grids not monotone: 1.25 times their spread, {:.3g}", uncertainty);
    return fmt::format("observed order {:.2f}, grid convergence index {:.3g}", order, uncertainty);
  }
} // namespace verify
