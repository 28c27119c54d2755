#include "solid/splitting.h"

#include <cmath>

#include "solid/walls.h"

namespace solid
{
  namespace
  {
    // Longest extent of the parallelogram: its direction times its length.
    Point extent(const Points &points, const std::size_t p)
    {
      const double a = points.rxx[p], b = points.rxy[p], c = points.ryx[p], d = points.ryy[p];
      const double xx = a * a + b * b, yy = c * c + d * d, xy = a * c + b * d;
      const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy);
      const double longest = mean + std::sqrt(half * half + xy * xy);
      const double angle = 0.5 * std::atan2(2. * xy, xx - yy);
      return std::sqrt(longest) * Point(std::cos(angle), std::sin(angle));
    }

    // r -> (I - u u^T/2) r: half as long along u.
    void halve(Points &points, const std::size_t p, const Point &u)
    {
      const double along_a = u[0] * points.rxx[p] + u[1] * points.ryx[p];
      const double along_b = u[0] * points.rxy[p] + u[1] * points.ryy[p];
      points.rxx[p] -= static_cast<float>(0.5 * along_a * u[0]);
      points.ryx[p] -= static_cast<float>(0.5 * along_a * u[1]);
      points.rxy[p] -= static_cast<float>(0.5 * along_b * u[0]);
      points.ryy[p] -= static_cast<float>(0.5 * along_b * u[1]);
    }

    void shift(Points &points, const std::size_t p, const Point &by, const Point &lower,
               const Point &upper)
    {
      points.vx[p] += points.lxx[p] * by[0] + points.lxy[p] * by[1];
      points.vy[p] += points.lyx[p] * by[0] + points.lyy[p] * by[1];
      points.x[p] = std::min(std::max(points.x[p] + by[0], lower[0]), upper[0]);
      points.y[p] = std::min(std::max(points.y[p] + by[1], lower[1]), upper[1]);
    }

    void split(Points &points, const std::size_t p, const Point &extent, const Point &lower,
               const Point &upper)
    {
      points.mass[p] *= 0.5;
      halve(points, p, extent.normalized());
      for_each_array(points,
                     [&](const char *, auto &array)
                     {
                       const auto value = array[p];
                       array.push_back(value);
                     });
      const std::size_t last = points.size() - 1, place = points.active++;
      for_each_array(points,
                     [&](const char *, auto &array) { std::swap(array[place], array[last]); });
      shift(points, p, -0.25 * extent, lower, upper);
      shift(points, place, 0.25 * extent, lower, upper);
    }
  } // namespace

  void square_edges(Points &points, const double density, const std::size_t begin)
  {
    if (!points.may_split)
      return;
    for (std::size_t p = begin; p < points.size(); ++p)
    {
      points.rxx[p] = points.ryy[p] = static_cast<float>(std::sqrt(points.mass[p] / density));
      points.rxy[p] = points.ryx[p] = 0.f;
    }
  }

  void stretch(Points &points, const double dt, const PointRange range)
  {
    for (std::size_t p = range.begin; p < range.end; ++p)
    {
      const double xx = points.rxx[p], xy = points.rxy[p], yx = points.ryx[p], yy = points.ryy[p];
      points.rxx[p] = static_cast<float>(xx + dt * (points.lxx[p] * xx + points.lxy[p] * yx));
      points.rxy[p] = static_cast<float>(xy + dt * (points.lxx[p] * xy + points.lxy[p] * yy));
      points.ryx[p] = static_cast<float>(yx + dt * (points.lyx[p] * xx + points.lyy[p] * yx));
      points.ryy[p] = static_cast<float>(yy + dt * (points.lyx[p] * xy + points.lyy[p] * yy));
    }
  }

  void split_points(Solid &solid)
  {
    Points &points = solid.points;
    if (!points.may_split)
      return;
    const double dx = solid.grid.dx;
    const int fewest = std::min(solid.points_per_cell[0], solid.points_per_cell[1]);
    const double longest = std::max(0.8, 1.2 / fewest) * dx; // one point a cell starts a cell long
    const double least = solid.material.density * dx * dx / 64.;
    Point lower = solid.domain.lower, upper = solid.domain.upper();
    bound_by_walls(solid.supports, solid.time, lower, upper);
    const std::size_t count = points.active;
    for (std::size_t p = 0; p < count; ++p)
    {
      // Points that ride with a held region are where their support says.
      if (points.regions[p] != 0 || points.mass[p] < 2. * least)
        continue;
      const Point along = extent(points, p);
      if (along.norm() <= longest)
        continue;
      split(points, p, along, lower, upper);
      ++solid.split_points;
      solid.grid.drift = dx;
    }
  }
} // namespace solid
