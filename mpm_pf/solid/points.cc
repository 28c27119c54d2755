#include "solid/points.h"

#include <cstring>

namespace solid
{
  void reserve(Points &points, const std::size_t count)
  {
    for_each_array(points, [&](const char *, auto &array) { array.reserve(count); });
  }

  void add_point(Points &points, const Fraction &fraction, const Point &position, const double mass)
  {
    // Points are most of the memory in use: an eighth in hand, not as much again.
    if (const std::size_t size = points.size(); size == points.x.capacity())
      reserve(points, size + size / 8 + 64);
    for_each_array(points, [](const char *, auto &array) { array.push_back(0); });
    const std::size_t p = points.size() - 1;
    points.X[p] = fraction.encode(position[0], 0);
    points.Y[p] = fraction.encode(position[1], 1);
    points.x[p] = fraction.decode(points.X[p], 0);
    points.y[p] = fraction.decode(points.Y[p], 1);
    points.mass[p] = mass;
    points.jacobian[p] = 1.;
  }

  void reorder(Points &points, const std::vector<std::uint32_t> &order, Array<double> &scratch,
               const int threads)
  {
    scratch.resize(order.size());
    const auto n = static_cast<std::ptrdiff_t>(order.size());
    for_each_array(points,
                   [&](const char *, auto &array)
                   {
                     using Value = typename std::decay_t<decltype(array)>::value_type;
                     auto *sorted = reinterpret_cast<unsigned char *>(scratch.data());
#pragma omp parallel for schedule(static) num_threads(threads)
                     for (std::ptrdiff_t k = 0; k < n; ++k)
                       std::memcpy(sorted + k * sizeof(Value), &array[order[k]], sizeof(Value));
#pragma omp parallel for schedule(static) num_threads(threads)
                     for (std::ptrdiff_t k = 0; k < n; ++k)
                       std::memcpy(&array[k], sorted + k * sizeof(Value), sizeof(Value));
                   });
  }
} // namespace solid
