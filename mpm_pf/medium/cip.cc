#include "medium/cip.h"

#include "medium/current_gradients.h"
#include "medium/sides.h"
#include "medium/upwind_cell.h"

namespace medium
{
  namespace
  {
    struct CellSize
    {
      double x, y;
    };

    struct CarriedRows
    {
      FieldRows f, x, y;
    };

    /// Value and gradient at the departure point, in cell units, towards increasing x and y.
    struct Profile
    {
      double f, g, k;
    };

    /// Type A at node i. Coordinates run from the node towards the upwind corner, in cells.
    // Forced inline: as a call it would keep the loop over nodes scalar.
    [[gnu::always_inline]] inline Profile type_a(const CarriedRows &r, int i, const Departure &d,
                                                 CellSize cell)
    {
      const bool right = d.x >= 0., up = d.y >= 0.;
      const double sx = right ? 1. : -1., sy = up ? 1. : -1.;
      const double x = d.x * sx, y = d.y * sy;
      const UpwindCorners f = corners(r.f, i, right, up, 1.);
      const UpwindCorners g = corners(r.x, i, right, up, sx * cell.x);
      const UpwindCorners k = corners(r.y, i, right, up, sy * cell.y);
      const double f00 = f.near, f10 = f.right, f01 = f.up, f11 = f.far;
      const double g00 = g.near, g10 = g.right, g01 = g.up;
      const double k00 = k.near, k10 = k.right, k01 = k.up;
      const double c30 = (g00 + g10) - 2. * (f10 - f00), c20 = 3. * (f10 - f00) - (2. * g00 + g10);
      const double c03 = (k00 + k01) - 2. * (f01 - f00), c02 = 3. * (f01 - f00) - (2. * k00 + k01);
      const double gd = g01 - g00, kd = k10 - k00;
      const double c11 = gd + kd - ((f00 - f01) - (f10 - f11)), c12 = gd - c11, c21 = kd - c11;
      return {((c30 * x + c20 + c21 * y) * x + g00 + c11 * y) * x +
                  ((c03 * y + c02 + c12 * x) * y + k00) * y + f00,
              sx * ((3. * c30 * x + 2. * (c20 + c21 * y)) * x + g00 + (c11 + c12 * y) * y),
              sy * ((3. * c03 * y + 2. * (c02 + c12 * x)) * y + k00 + (c11 + c21 * x) * x)};
    }

    [[gnu::always_inline]] inline void carry_node(const CarriedRows &r, int i, const Departure &d,
                                                  CellSize cell)
    {
      const Profile p = type_a(r, i, d, cell);
      r.f.next[i] = p.f;
      r.x.next[i] = (1. / cell.x) * (d.xx * p.g + d.yx * p.k);
      r.y.next[i] = (1. / cell.y) * (d.xy * p.g + d.yy * p.k);
    }

    double type_a_row(const CarriedRows &r, const VelocityRows &w, int j, double dt,
                      const Mesh &mesh)
    {
      const CellSize cell{mesh.spacing[0], mesh.spacing[1]};
      const StepInCells step{dt / cell.x, dt / cell.y};
#pragma omp simd
      for (int i = 0; i < mesh.nodes[0]; ++i)
        carry_node(r, i, departure(w, i, step), cell);
      for_entering_nodes(mesh, j, w, step,
                         [&](int i, const Departure &d) { carry_node(r, i, d, cell); });
      return largest_shift(w, mesh.nodes[0], step);
    }
  } // namespace

  double cip_type_a(const CipFields &a, const Velocity &velocity, double dt, const Mesh &mesh)
  {
    return sweep_rows(a, mesh,
                      [&](const CurrentGradients &g, int j)
                      {
                        return type_a_row(
                            {{a.f->row(j - 1), a.f->row(j), a.f->row(j + 1), a.new_f->row(j)},
                             {g.x(2), g.x(1), g.x(0), a.new_x->row(j)},
                             {g.y(2), g.y(1), g.y(0), a.new_y->row(j)}},
                            velocity_rows(velocity, j), j, dt, mesh);
                      });
  }
} // namespace medium
