#include "point_numbers.h"

#include <algorithm>

namespace fe
{
  namespace
  {
    constexpr int width = 10;
  }

  std::vector<double> gather_points(const Discretisation &d, const std::vector<PointState> &points)
  {
    std::vector<double> numbers(points.size() * width, 0.);
    for (std::size_t k = 0; k < points.size(); ++k)
      if (d.owned[k / d.points_per_cell])
      {
        double *n = numbers.data() + k * width;
        std::copy_n(points[k].stress.data(), 4, n);
        std::copy_n(points[k].F.data(), 4, n + 4);
        n[8] = points[k].plastic_strain;
        n[9] = points[k].plastic_work;
      }
    sum_over_processes(numbers);
    return numbers;
  }

  std::vector<PointState> unpack_points(const std::vector<double> &numbers)
  {
    std::vector<PointState> points(numbers.size() / width);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const double *n = numbers.data() + k * width;
      std::copy_n(n, 4, points[k].stress.data());
      std::copy_n(n + 4, 4, points[k].F.data());
      points[k].plastic_strain = n[8];
      points[k].plastic_work = n[9];
    }
    return points;
  }
} // namespace fe
