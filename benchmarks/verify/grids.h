// Order of convergence and discretisation uncertainty from three grids (Roache's grid convergence
// index).
//
// For errors C h^p: p solves e23/(r23^p - 1) = r12^p e12/(r12^p - 1), with e12 the difference
// between the finest two and r12 the ratio of their mesh sizes; the error left on the finest grid
// is e12/(r12^p - 1), and 1.25 times it is the index. Known answer: h = 1, 2, 4 -> 0.97050,
// 0.96854, 0.96178 gives p = 1.78617, f(0) = 0.971300, 0.10308 % and 0.35625 %.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace verify
{
  /// Safety factor for three grids.
  inline constexpr double safety = 1.25;

  struct GridUncertainty
  {
    bool monotone = false;       // else: 1.25 times the spread
    double order = 0.;           // observed; 0 if not monotone
    double uncertainty = 0.;     // of the grid asked for, same unit as the differences
    std::optional<double> limit; // extrapolated value, of a number only
    std::string text() const;    // one sentence for the report
  };

  /// `h`: mesh sizes, any order, the three finest are used; `difference[i]` between grids i and i+1
  /// once sorted from fine to coarse, as `difference(i, j)` gives it for indices into `h`; signed
  /// for numbers, unsigned norms for curves. `wanted`: index into `h` of the grid whose uncertainty
  /// is asked for.
  template <typename Difference>
  GridUncertainty grid_uncertainty(const std::vector<double> &h, const Difference &difference,
                                   std::size_t wanted, double order_at_most);

  /// The same for three numbers; fills `limit`.
  GridUncertainty grid_uncertainty(const std::vector<double> &h, const std::vector<double> &f,
                                   std::size_t wanted, double order_at_most);

  /// Slope of log(error) over log(h), least squares. Throws MissingData if an error is zero or not
  /// finite.
  double observed_order(const std::vector<double> &h, const std::vector<double> &error);

  /// What the arithmetic behind needs of three grids, numbered from the finest.
  struct ThreeGrids
  {
    double e12 = 0., e23 = 0.; // differences of their results
    double r12 = 1., r23 = 1.; // ratios of h, coarse over fine
    double size_ratio = 1.;    // h of the grid asked for over the finest h
    double spread = 0.;        // largest difference among the three
  };
  GridUncertainty grid_uncertainty(const ThreeGrids &, double order_at_most);
  /// Indices of `h` from fine to coarse.
  std::vector<std::size_t> fine_to_coarse(const std::vector<double> &h);

  template <typename Difference>
  GridUncertainty grid_uncertainty(const std::vector<double> &h, const Difference &difference,
                                   const std::size_t wanted, const double order_at_most)
  {
    const auto k = fine_to_coarse(h);
    ThreeGrids grids;
    grids.e12 = difference(k[0], k[1]), grids.e23 = difference(k[1], k[2]);
    grids.r12 = h[k[1]] / h[k[0]], grids.r23 = h[k[2]] / h[k[1]];
    grids.size_ratio = h[wanted] / h[k[0]];
    for (const double e : {grids.e12, grids.e23, difference(k[0], k[2])})
      grids.spread = std::max(grids.spread, e < 0. ? -e : e);
    return grid_uncertainty(grids, order_at_most);
  }
} // namespace verify
