#include "medium/eulerian.h"

#include "medium/sides.h"

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

    /// v . grad f dt by WENO at c[0], for the shifts v dt in cells.
    [[gnu::always_inline]] inline double weno_change(const double *c, std::ptrdiff_t pitch,
                                                     double shift_x, double shift_y)
    {
      return shift_x * weno_slope(c, 1, shift_x) + shift_y * weno_slope(c, pitch, shift_y);
    }

    /// A node in its row, and those in the rows beside it.
    struct Neighbours
    {
      const double *here, *below, *above;
    };

    /// The same by first differences.
    [[gnu::always_inline]] inline double upwind_change(const Neighbours &at, double shift_x,
                                                       double shift_y)
    {
      const double *c = at.here;
      const double west = c[0] - c[-1], east = c[1] - c[0];
      const double south = c[0] - *at.below, north = *at.above - c[0];
      return shift_x * (shift_x >= 0. ? west : east) + shift_y * (shift_y >= 0. ? south : north);
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
          target[i] = stage.old * old[i] +
                      stage.now * (c[i] - weno_change(c + i, pitch, x * u[i], y * v[i]));
        for_mirror_nodes(mesh, j,
                         [&](int i, const MirrorSides &sides)
                         {
                           const double in_x = along_side_x(x * u[i], sides);
                           const double in_y = along_side_y(y * v[i], sides);
                           target[i] = stage.old * old[i] +
                                       stage.now * (c[i] - weno_change(c + i, pitch, in_x, in_y));
                         });
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
        target[i] = c[i] - upwind_change({c + i, below + i, above + i}, x * u[i], y * v[i]);
      for_mirror_nodes(mesh, j,
                       [&](int i, const MirrorSides &sides)
                       {
                         target[i] = c[i] - upwind_change({c + i, below + i, above + i},
                                                          along_side_x(x * u[i], sides),
                                                          along_side_y(y * v[i], sides));
                       });
    }
    f.swap(next);
  }
} // namespace medium
