#include "medium/eulerian.h"

namespace medium
{
  namespace
  {
    /// Fifth-order WENO value of a one-sided difference quotient from five neighbouring
    /// differences, a furthest upwind.
    [[gnu::always_inline]] inline double weno_difference(double a, double b, double c, double d,
                                                         double e)
    {
      const double p1 = a / 3. - 7. * b / 6. + 11. * c / 6.;
      const double p2 = -b / 6. + 5. * c / 6. + d / 3.;
      const double p3 = c / 3. + 5. * d / 6. - e / 6.;
      const double h1 = a - 2. * b + c, l1 = a - 4. * b + 3. * c;
      const double h2 = b - 2. * c + d, l2 = b - d;
      const double h3 = c - 2. * d + e, l3 = 3. * c - 4. * d + e;
      const double s1 = 13. / 12. * h1 * h1 + 0.25 * l1 * l1;
      const double s2 = 13. / 12. * h2 * h2 + 0.25 * l2 * l2;
      const double s3 = 13. / 12. * h3 * h3 + 0.25 * l3 * l3;
      constexpr double tiny = 1e-10; // differences of phi are of order 0.3 at a front
      const double w1 = 0.1 / ((tiny + s1) * (tiny + s1));
      const double w2 = 0.6 / ((tiny + s2) * (tiny + s2));
      const double w3 = 0.3 / ((tiny + s3) * (tiny + s3));
      return (w1 * p1 + w2 * p2 + w3 * p3) / (w1 + w2 + w3);
    }

    /// Upwind difference at v[0] along a line of values v[-3 stride] ... v[3 stride], per spacing.
    [[gnu::always_inline]] inline double weno_slope(const double *v, std::ptrdiff_t stride,
                                                    double velocity)
    {
      const bool from_low = velocity >= 0.;
      const double d0 = v[-2 * stride] - v[-3 * stride], d1 = v[-stride] - v[-2 * stride];
      const double d2 = v[0] - v[-stride], d3 = v[stride] - v[0];
      const double d4 = v[2 * stride] - v[stride], d5 = v[3 * stride] - v[2 * stride];
      return weno_difference(from_low ? d0 : d5, from_low ? d1 : d4, from_low ? d2 : d3,
                             from_low ? d3 : d2, from_low ? d4 : d1);
    }

    /// next = a f + b (g + dt L(g)): one Runge-Kutta stage.
    struct Stage
    {
      double old, now;
    };
    void weno_stage(const Field<double> &f, const Field<double> &g, Field<double> &next,
                    const Velocity &velocity, double dt, Stage stage, const Mesh &mesh, Image image)
    {
      const double x = dt / mesh.spacing[0], y = dt / mesh.spacing[1];
#pragma omp parallel for schedule(static)
      for (int j = 0; j < mesh.nodes[1]; ++j)
      {
        const double *u = velocity.x.row(j), *v = velocity.y.row(j), *old = f.row(j);
        const double *c = g.row(j);
        const std::ptrdiff_t pitch = g.pitch();
        double *target = next.row(j);
#pragma omp simd
        for (int i = 0; i < mesh.nodes[0]; ++i)
        {
          const double gx = weno_slope(c + i, 1, u[i]);
          const double gy = weno_slope(c + i, pitch, v[i]);
          target[i] = stage.old * old[i] + stage.now * (c[i] - x * u[i] * gx - y * v[i] * gy);
        }
      }
      fill_ghosts(next, mesh, Parity::even, image);
    }
  } // namespace

  void weno5(Field<double> &f, Field<double> &first, Field<double> &second,
             const Velocity &velocity, double dt, const Mesh &mesh, Image image)
  {
    weno_stage(f, f, first, velocity, dt, {0., 1.}, mesh, image);
    weno_stage(f, first, second, velocity, dt, {3. / 4., 1. / 4.}, mesh, image);
    weno_stage(f, second, first, velocity, dt, {1. / 3., 2. / 3.}, mesh, image);
    f.swap(first);
  }

  void upwind(Field<double> &f, Field<double> &next, const Velocity &velocity, double dt,
              const Mesh &mesh)
  {
    const double x = dt / mesh.spacing[0], y = dt / mesh.spacing[1];
#pragma omp parallel for schedule(static)
    for (int j = 0; j < mesh.nodes[1]; ++j)
    {
      const double *u = velocity.x.row(j), *v = velocity.y.row(j);
      const double *c = f.row(j), *below = f.row(j - 1), *above = f.row(j + 1);
      double *target = next.row(j);
#pragma omp simd
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const double west = c[i] - c[i - 1], east = c[i + 1] - c[i];
        const double south = c[i] - below[i], north = above[i] - c[i];
        target[i] =
            c[i] - x * u[i] * (u[i] >= 0. ? west : east) - y * v[i] * (v[i] >= 0. ? south : north);
      }
    }
    f.swap(next);
  }
} // namespace medium
