#include "medium/reinitialisation.h"

#include <algorithm>
#include <cmath>

namespace medium
{
  namespace
  {
    template <class Visit>
    void each_band_node(const Distance &distance, Visit visit)
    {
      const Tiles &tiles = distance.tiles;
#pragma omp parallel for schedule(static)
      for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column)
          if (tiles.at(column, row) == Activity::active)
            for (int j = tiles.first_row(row); j < tiles.end_row(row); ++j)
              for (int i = tiles.first_node(column); i < tiles.end_node(column); ++i)
                visit(i, j);
    }

    double smaller(double a, double b)
    {
      return a * b <= 0. ? 0. : std::abs(a) < std::abs(b) ? a : b;
    }

    /// Second-order ENO differences to the left and right of f, `step` apart in memory.
    struct Differences
    {
      Differences(const double *f, std::ptrdiff_t step, double h)
      {
        const double left = f[0] - 2. * f[-step] + f[-2 * step],
                     here = f[step] - 2. * f[0] + f[-step],
                     right = f[2 * step] - 2. * f[step] + f[0];
        minus = (f[0] - f[-step] + 0.5 * smaller(left, here)) / h;
        plus = (f[step] - f[0] - 0.5 * smaller(here, right)) / h;
      }
      double minus, plus;
    };

    /// |grad psi| by Godunov: information runs away from the contour.
    double godunov(const double *psi, std::ptrdiff_t pitch, const Mesh &mesh, bool positive)
    {
      const Differences x(psi, 1, mesh.spacing[0]), y(psi, pitch, mesh.spacing[1]);
      const auto upwind = [&](const Differences &d)
      {
        const double a = positive ? std::max(d.minus, 0.) : std::min(d.minus, 0.),
                     b = positive ? std::min(d.plus, 0.) : std::max(d.plus, 0.);
        return std::max(a * a, b * b);
      };
      return std::sqrt(upwind(x) + upwind(y));
    }

    bool next_to_contour(const double *psi, std::ptrdiff_t pitch)
    {
      return psi[0] * psi[1] <= 0. || psi[0] * psi[-1] <= 0. || psi[0] * psi[pitch] <= 0. ||
             psi[0] * psi[-pitch] <= 0.;
    }

    /// Russo and Smereka's distance of a node next to the contour.
    double subcell_distance(const double *psi, std::ptrdiff_t pitch, const Mesh &mesh)
    {
      const double hx = mesh.spacing[0], hy = mesh.spacing[1];
      const double x = (psi[1] - psi[-1]) / (2. * hx), y = (psi[pitch] - psi[-pitch]) / (2. * hy);
      const double one_sided =
          std::max(std::max(std::abs(psi[1] - psi[0]), std::abs(psi[0] - psi[-1])) / hx,
                   std::max(std::abs(psi[pitch] - psi[0]), std::abs(psi[0] - psi[-pitch])) / hy);
      const double central = std::hypot(x, y);
      return psi[0] / (central > 0.5 * one_sided ? central : std::max(one_sided, 1e-300));
    }

    /// The first equation: psi from `start`, in the band of `distance`, by steps of `step`.
    struct FirstEquation
    {
      const Field<double> &start;
      const Distance &distance;
      const Mesh &mesh;
      double step;
    };

    /// One Euler step from `from` to `to`.
    void euler_step(Field<double> &to, const Field<double> &from, const FirstEquation &equation)
    {
      const Field<double> &start = equation.start;
      const Mesh &mesh = equation.mesh;
      const double step = equation.step;
      const std::ptrdiff_t pitch = start.pitch();
      const double h = std::min(mesh.spacing[0], mesh.spacing[1]);
      each_band_node(equation.distance,
                     [&](int i, int j)
                     {
                       const double *psi0 = &start(i, j), *psi = &from(i, j);
                       const bool positive = *psi0 > 0.;
                       const double sign = positive ? 1. : -1.;
                       to(i, j) =
                           next_to_contour(psi0, pitch)
                               ? *psi - step / h * (*psi - subcell_distance(psi0, pitch, mesh))
                               : *psi - step * sign * (godunov(psi, pitch, mesh, positive) - 1.);
                     });
    }
  } // namespace

  template <class T>
  void reinitialise(Distance &distance, const Field<T> &phi, double front_width, const Mesh &mesh)
  {
    const double scale = std::sqrt(2.) * front_width, band = distance.band;
    Field<double> start(distance.psi);
    each_band_node(distance,
                   [&](int i, int j)
                   {
                     const double value =
                         std::clamp(static_cast<double>(phi(i, j)), -1. + 1e-6, 1. - 1e-6);
                     start(i, j) = std::clamp(scale * std::atanh(value), -band, band);
                   });
    fill_ghosts(start, mesh);
    Field<double> psi(start), middle(start), end(start);
    const double h = std::min(mesh.spacing[0], mesh.spacing[1]), step = 0.45 * h;
    const int count = static_cast<int>(std::ceil(1.3 * band / step)) + 10;
    const FirstEquation equation{start, distance, mesh, step};
    for (int n = 0; n < count; ++n)
    {
      euler_step(middle, psi, equation);
      fill_ghosts(middle, mesh);
      euler_step(end, middle, equation);
      each_band_node(distance, [&](int i, int j) { psi(i, j) = 0.5 * (psi(i, j) + end(i, j)); });
      fill_ghosts(psi, mesh);
    }
    each_band_node(distance,
                   [&](int i, int j) { distance.psi(i, j) = std::clamp(psi(i, j), -band, band); });
  }

  template void reinitialise(Distance &, const Field<double> &, double, const Mesh &);
  template void reinitialise(Distance &, const Field<float> &, double, const Mesh &);

  void march_extension(Field<double> &field, const Distance &distance,
                       const Field<unsigned char> &material, double depth, const Mesh &mesh)
  {
    Field<double> psi(distance.psi), old(field);
    fill_ghosts(psi, mesh);
    const double hx = mesh.spacing[0], hy = mesh.spacing[1], step = 0.5 * std::min(hx, hy);
    const std::ptrdiff_t pitch = field.pitch();
    const int count = static_cast<int>(std::ceil(1.5 * distance.band / step)) + 10;
    for (int n = 0; n < count; ++n)
    {
      fill_ghosts(field, mesh);
      old = field;
      each_band_node(distance,
                     [&](int i, int j)
                     {
                       const double *d = &psi(i, j), *q = &old(i, j);
                       if (*d >= depth && (material.empty() || material(i, j)))
                         return;
                       const double x = (d[1] - d[-1]) / (2. * hx),
                                    y = (d[pitch] - d[-pitch]) / (2. * hy);
                       const double size = std::max(std::hypot(x, y), 1e-12);
                       const double q_x = x > 0. ? (q[1] - q[0]) / hx : (q[0] - q[-1]) / hx,
                                    q_y = y > 0. ? (q[pitch] - q[0]) / hy : (q[0] - q[-pitch]) / hy;
                       field(i, j) = *q + step * (x * q_x + y * q_y) / size;
                     });
    }
  }
} // namespace medium
