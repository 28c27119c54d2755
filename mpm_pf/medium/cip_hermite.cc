#include "medium/cip.h"
#include "medium/current_gradients.h"
#include "medium/sides.h"
#include "medium/upwind_cell.h"

namespace medium
{
  namespace
  {
    /// Cubic Hermite weights at t of the near and far value and slope, or a derivative of them.
    struct Weights
    {
      double near, far, near_slope, far_slope;
    };
    // Forced inline, all of them: as calls they would keep the loop over nodes scalar.
    [[gnu::always_inline]] inline Weights value_at(double t)
    {
      const double s = 1. - t;
      return {s * s * (1. + 2. * t), t * t * (3. - 2. * t), t * s * s, -t * t * s};
    }
    [[gnu::always_inline]] inline Weights slope_at(double t)
    {
      return {-6. * t * (1. - t), 6. * t * (1. - t), (1. - t) * (1. - 3. * t), t * (3. * t - 2.)};
    }
    [[gnu::always_inline]] inline Weights curvature_at(double t)
    {
      return {12. * t - 6., 6. - 12. * t, 6. * t - 4., 6. * t - 2.};
    }

    /// f, f_x, f_y, f_xy at one corner of the cell, in cell units along the upwind directions.
    struct Corner
    {
      double f, x, y, xy;
    };
    struct Cell
    {
      Corner near, right, up, far;
    };

    [[gnu::always_inline]] inline double along(const Weights &w, double near, double far,
                                               double near_slope, double far_slope)
    {
      return w.near * near + w.far * far + w.near_slope * near_slope + w.far_slope * far_slope;
    }

    /// Tensor product of weights along x and y.
    [[gnu::always_inline]] inline double combine(const Weights &x, const Weights &y, const Cell &c)
    {
      return along(y, along(x, c.near.f, c.right.f, c.near.x, c.right.x),
                   along(x, c.up.f, c.far.f, c.up.x, c.far.x),
                   along(x, c.near.y, c.right.y, c.near.xy, c.right.xy),
                   along(x, c.up.y, c.far.y, c.up.xy, c.far.xy));
    }

    struct CarriedRows
    {
      FieldRows f, x, y, xy;
    };

    [[gnu::always_inline]] inline void carry_node(const CarriedRows &r, int i, const Departure &d,
                                                  const Point &spacing)
    {
      const double cell_x = spacing[0], cell_y = spacing[1];
      const bool right = d.x >= 0., up = d.y >= 0.;
      const double sx = right ? 1. : -1., sy = up ? 1. : -1.;
      const double tx = d.x * sx, ty = d.y * sy;
      const UpwindCorners f = corners(r.f, i, right, up, 1.);
      const UpwindCorners g = corners(r.x, i, right, up, sx * cell_x);
      const UpwindCorners k = corners(r.y, i, right, up, sy * cell_y);
      const UpwindCorners m = corners(r.xy, i, right, up, sx * sy * cell_x * cell_y);
      const Cell cell{{f.near, g.near, k.near, m.near},
                      {f.right, g.right, k.right, m.right},
                      {f.up, g.up, k.up, m.up},
                      {f.far, g.far, k.far, m.far}};
      const Weights x = value_at(tx), y = value_at(ty), x1 = slope_at(tx), y1 = slope_at(ty);
      const double f_x = sx * combine(x1, y, cell), f_y = sy * combine(x, y1, cell);
      const double f_xy = sx * sy * combine(x1, y1, cell);
      const double f_xx = combine(curvature_at(tx), y, cell);
      const double f_yy = combine(x, curvature_at(ty), cell);
      r.f.next[i] = combine(x, y, cell);
      r.x.next[i] = (d.xx * f_x + d.yx * f_y) / cell_x;
      r.y.next[i] = (d.xy * f_x + d.yy * f_y) / cell_y;
      r.xy.next[i] =
          (d.xx * d.xy * f_xx + (d.xx * d.yy + d.xy * d.yx) * f_xy + d.yx * d.yy * f_yy) /
          (cell_x * cell_y);
    }

    double hermite_row(const CarriedRows &r, const VelocityRows &w, int j, double dt,
                       const Mesh &mesh)
    {
      const Point spacing = mesh.spacing;
      const StepInCells step{dt / spacing[0], dt / spacing[1]};
      const int count = mesh.nodes[0];
#pragma omp simd
      for (int i = 0; i < count; ++i)
        carry_node(r, i, departure(w, i, step), spacing);
      for_entering_nodes(mesh, j, w, step,
                         [&](int i, const Departure &d) { carry_node(r, i, d, spacing); });
      return largest_shift(w, count, step);
    }
  } // namespace

  double cip_hermite(const CipFields &a, const Velocity &velocity, double dt, const Mesh &mesh)
  {
    return sweep_rows(a, mesh,
                      [&](const CurrentGradients &g, int j)
                      {
                        return hermite_row(
                            {{a.f->row(j - 1), a.f->row(j), a.f->row(j + 1), a.new_f->row(j)},
                             {g.x(2), g.x(1), g.x(0), a.new_x->row(j)},
                             {g.y(2), g.y(1), g.y(0), a.new_y->row(j)},
                             {g.xy(2), g.xy(1), g.xy(0), a.new_xy->row(j)}},
                            velocity_rows(velocity, j), j, dt, mesh);
                      });
  }
} // namespace medium
