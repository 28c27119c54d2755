#include "solid/fields.h"

#include <limits>
#include <numeric>

namespace solid
{
  namespace
  {
    Stress stress(const Points &points, const std::size_t p)
    {
      return {points.sxx[p], points.syy[p], points.szz[p], points.sxy[p]};
    }

    template <typename F>
    std::vector<double> each(const PointSelection &chosen, F &&f)
    {
      std::vector<double> values(chosen.size());
      for (std::size_t k = 0; k < chosen.size(); ++k)
        values[k] = f(chosen[k]);
      return values;
    }

    std::vector<double> displacement(const Solid &solid, const int axis,
                                     const PointSelection &chosen)
    {
      const Points &points = solid.points;
      return each(chosen,
                  [&](const std::size_t p)
                  {
                    return axis == 0 ? points.x[p] - solid.fraction.decode(points.X[p], 0)
                                     : points.y[p] - solid.fraction.decode(points.Y[p], 1);
                  });
    }

    // Component of ln(F F^T)/2 by the eigenvalues of F F^T; F row by row.
    double hencky(const std::array<double, 4> &F, const int axis)
    {
      const double xx = F[0] * F[0] + F[1] * F[1], yy = F[2] * F[2] + F[3] * F[3];
      const double xy = F[0] * F[2] + F[1] * F[3];
      const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), radius = std::hypot(half, xy);
      const double large = std::log(mean + radius), small = std::log(mean - radius);
      const double per = radius > 1e-8 * mean ? 0.5 * (large - small) / radius : 1. / mean;
      return 0.5 * (0.5 * (large + small) + (axis == 0 ? per : -per) * half);
    }

    scene::Box box_of(const Solid &solid, const Frame frame, const PointSelection &chosen)
    {
      constexpr double most = std::numeric_limits<double>::max();
      scene::Box box{Point(most, most), Point(-most, -most)};
      for (const std::uint32_t p : chosen)
      {
        const Point x = position(solid, p, frame);
        box.lower = box.lower.cwiseMin(x), box.upper = box.upper.cwiseMax(x);
      }
      return box;
    }

    constexpr double fitted_cells = 2.; // each way

    /// What the fits at the chosen points take into account.
    PointSelection around(const Solid &solid, const PointSelection &chosen)
    {
      scene::Box box = box_of(solid, Frame::material, chosen);
      const Point margin = Point::Constant(fitted_cells * solid.grid.dx);
      box.lower -= margin, box.upper += margin;
      return points_in(solid, Frame::material, box);
    }

    std::vector<double> log_strain(const Solid &solid, const int axis, const PointSelection &chosen)
    {
      const Neighbours neighbours(solid, Frame::material, around(solid, chosen));
      const std::vector<double> ux = displacement(solid, 0, neighbours.chosen);
      const std::vector<double> uy = displacement(solid, 1, neighbours.chosen);
      return each(chosen,
                  [&](const std::size_t p)
                  {
                    const Point X = position(solid, p, Frame::material);
                    const Fit x = fit(solid, neighbours, Frame::material, ux, X);
                    const Fit y = fit(solid, neighbours, Frame::material, uy, X);
                    return hencky({1. + x.dx, x.dy, y.dx, 1. + y.dy}, axis);
                  });
    }
  } // namespace

  Point position(const Solid &solid, const std::size_t p, const Frame frame)
  {
    return frame == Frame::material ? solid.fraction.initial(solid.points, p)
                                    : Point(solid.points.x[p], solid.points.y[p]);
  }

  double area_of(const Solid &solid, const std::size_t p, const Frame frame)
  {
    const double initial = solid.points.mass[p] / solid.material.density;
    return frame == Frame::material ? initial : initial * solid.points.jacobian[p];
  }

  PointSelection all_points(const Solid &solid)
  {
    PointSelection all(solid.points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  PointSelection points_in(const Solid &solid, const Frame frame, const scene::Box &box)
  {
    PointSelection inside;
    for (std::size_t p = 0; p < solid.points.size(); ++p)
    {
      const Point x = position(solid, p, frame);
      if ((x.array() >= box.lower.array()).all() && (x.array() <= box.upper.array()).all())
        inside.push_back(static_cast<std::uint32_t>(p));
    }
    return inside;
  }

  Neighbours::Neighbours(const Solid &solid, const Frame frame, PointSelection some)
      : chosen(std::move(some)), lower(solid.domain.lower), size(solid.grid.dx), count{1, 1}
  {
    if (!chosen.empty())
    {
      const scene::Box box = box_of(solid, frame, chosen);
      lower = box.lower;
      // Bodies far apart in a large domain: no more than a few cells a point.
      const Point extent = box.upper - box.lower;
      size = std::max(size, std::sqrt(extent.prod() / (4. * static_cast<double>(chosen.size()))));
      size = std::max(size, extent.maxCoeff() / (4. * static_cast<double>(chosen.size())));
      for (int k = 0; k < 2; ++k)
        count[k] = static_cast<int>(extent[k] / size) + 1;
    }
    std::vector<std::size_t> cell(chosen.size());
    start.assign(static_cast<std::size_t>(count[0]) * count[1] + 1, 0);
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
      const Point s = (position(solid, chosen[k], frame) - lower) / size;
      const int i = std::min(std::max(static_cast<int>(s[0]), 0), count[0] - 1);
      const int j = std::min(std::max(static_cast<int>(s[1]), 0), count[1] - 1);
      cell[k] = static_cast<std::size_t>(j) * count[0] + i;
      ++start[cell[k] + 1];
    }
    for (std::size_t k = 1; k < start.size(); ++k)
      start[k] += start[k - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    order.resize(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k)
      order[next[cell[k]]++] = static_cast<std::uint32_t>(k);
  }

  Fit fit(const Solid &solid, const Neighbours &neighbours, const Frame frame,
          const std::vector<double> &field, const Point &at)
  {
    const double reach = fitted_cells * solid.grid.dx;
    // Normal equations of a + b X + c Y: sums of weight times 1, X, Y, XX, XY, YY and f, fX, fY.
    std::array<double, 9> m{};
    double closest = std::numeric_limits<double>::max();
    neighbours.near(at, reach,
                    [&](const std::size_t k)
                    {
                      const Point d = (position(solid, neighbours.chosen[k], frame) - at) / reach;
                      const double r2 = d.squaredNorm(), X = d[0], Y = d[1], f = field[k];
                      if (r2 >= 1.)
                        return;
                      closest = std::min(closest, r2);
                      const double w = (1. - r2) * (1. - r2) * (1. - r2);
                      const double terms[9] = {1., X, Y, X * X, X * Y, Y * Y, f, f * X, f * Y};
                      for (int n = 0; n < 9; ++n)
                        m[n] += w * terms[n];
                    });
    // Inverse of the symmetric matrix by its cofactors.
    const double c00 = m[3] * m[5] - m[4] * m[4], c01 = m[2] * m[4] - m[1] * m[5];
    const double c02 = m[1] * m[4] - m[2] * m[3], c11 = m[0] * m[5] - m[2] * m[2];
    const double c12 = m[1] * m[2] - m[0] * m[4], c22 = m[0] * m[3] - m[1] * m[1];
    const double det = m[0] * c00 + m[1] * c01 + m[2] * c02;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double scale = (m[0] + m[3] + m[5]) / 3.;
    if (closest > 0.25 || !(det > 1e-9 * scale * scale * scale))
      return {none, none, none};
    return {(c00 * m[6] + c01 * m[7] + c02 * m[8]) / det,
            (c01 * m[6] + c11 * m[7] + c12 * m[8]) / det / reach,
            (c02 * m[6] + c12 * m[7] + c22 * m[8]) / det / reach};
  }

  std::vector<double> field(const Solid &solid, const std::string &name,
                            const PointSelection &chosen)
  {
    const Points &points = solid.points;
    const auto of = [&](const auto &array)
    { return each(chosen, [&](const std::size_t p) { return static_cast<double>(array[p]); }); };
    if (name == "von_mises")
      return each(chosen, [&](const std::size_t p) { return von_mises(stress(points, p)); });
    if (name == "pressure")
      return each(chosen, [&](const std::size_t p) { return pressure(stress(points, p)); });
    if (name == "yielded")
      return each(chosen,
                  [&](const std::size_t p)
                  {
                    return solid.material.yield_stress && von_mises(stress(points, p)) >
                                                              0.99 * *solid.material.yield_stress
                               ? 1.
                               : 0.;
                  });
    if (name == "area")
      return each(chosen, [&](const std::size_t p) { return area_of(solid, p, Frame::current); });
    if (name == "displacement_x")
      return displacement(solid, 0, chosen);
    if (name == "displacement_y")
      return displacement(solid, 1, chosen);
    if (name == "log_strain_xx")
      return log_strain(solid, 0, chosen);
    if (name == "log_strain_yy")
      return log_strain(solid, 1, chosen);
    if (name == "plastic_strain")
      return of(points.plastic);
    if (name == "stress_xx")
      return of(points.sxx);
    if (name == "stress_yy")
      return of(points.syy);
    if (name == "stress_zz")
      return of(points.szz);
    if (name == "stress_xy")
      return of(points.sxy);
    if (name == "velocity_x")
      return of(points.vx);
    if (name == "velocity_y")
      return of(points.vy);
    if (name == "jacobian")
      return of(points.jacobian);
    throw std::out_of_range("the material points know no quantity \"" + name + "\"");
  }
} // namespace solid
