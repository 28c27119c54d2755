// Values at the points, by the names of scene/quantities.h, and the search for points near a place.
#pragma once

#include <string>
#include <vector>

#include "solid/body.h"

namespace solid
{
  using scene::Frame;

  /// Position of point p in a frame: initial or current.
  Point position(const Solid &, std::size_t p, Frame);
  /// Area of point p in a frame.
  double area_of(const Solid &, std::size_t p, Frame);

  /// Some of the points, ascending.
  using PointSelection = std::vector<std::uint32_t>;
  PointSelection all_points(const Solid &);
  PointSelection points_in(const Solid &, Frame, const scene::Box &);

  /// Selected points by square cells, in one frame.
  struct Neighbours
  {
    PointSelection chosen;
    Point lower;
    double size;
    std::array<int, 2> count;
    std::vector<std::uint32_t> start,
        order; // of cell (i, j): chosen[order[start[k]]] to chosen[order[start[k + 1] - 1]]

    Neighbours(const Solid &, Frame, PointSelection);

    /// Call f(k) for all chosen[k] of cells that touch the square of half side `reach` around x.
    template <typename F>
    void near(const Point &x, const double reach, F &&f) const
    {
      std::array<int, 2> first, last;
      for (int k = 0; k < 2; ++k)
      {
        const auto index = [&](const double y)
        {
          const double s = std::floor((y - lower[k]) / size);
          return static_cast<int>(std::min(std::max(s, 0.), count[k] - 1.));
        };
        first[k] = index(x[k] - reach), last[k] = index(x[k] + reach);
      }
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
        {
          const std::size_t cell = static_cast<std::size_t>(j) * count[0] + i;
          for (std::uint32_t k = start[cell]; k < start[cell + 1]; ++k)
            f(order[k]);
        }
    }
  };

  /// Value and gradient at a place of a field of the points.
  struct Fit
  {
    double value, dx, dy;
  };
  /// Weighted linear least squares over the points within two cells; exact for linear fields, to
  /// the edge of the material. NaN if no point is within a cell or they lie on a line. `field` is
  /// of the chosen points.
  Fit fit(const Solid &, const Neighbours &, Frame, const std::vector<double> &field,
          const Point &at);

  /// A quantity of scene/quantities.h at the chosen points. log_strain is Hencky's, ln(F F^T)/2
  /// with F from fits of the displacement. Throws std::out_of_range for any other name.
  std::vector<double> field(const Solid &, const std::string &name, const PointSelection &);
} // namespace solid
