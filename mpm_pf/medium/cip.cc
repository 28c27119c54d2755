#include "medium/cip.h"

#include "medium/departure.h"

namespace medium
{
  namespace
  {
    struct CellSize
    {
      double x, y;
    };

    /// Rows of the fields that type A reads: the node's own, and the two neighbours.
    struct TypeARows
    {
      const double *f_below, *f, *f_above, *g_below, *g, *g_above, *k_below, *k, *k_above;
      double *new_f, *new_g, *new_k;
    };

    /// Value and gradient at the departure point, in cell units, towards increasing x and y.
    struct Profile
    {
      double f, g, k;
    };

    /// Type A at node i. Coordinates run from the node towards the upwind corner, in cells.
    inline Profile type_a(const TypeARows &r, int i, const Departure &d, CellSize cell)
    {
      const bool right = d.x >= 0., up = d.y >= 0.;
      const double sx = right ? 1. : -1., sy = up ? 1. : -1.;
      const double x = d.x * sx, y = d.y * sy;
      const double f_e = r.f[i + 1], f_w = r.f[i - 1], f_n = r.f_above[i], f_s = r.f_below[i];
      const double f_ne = r.f_above[i + 1], f_nw = r.f_above[i - 1];
      const double f_se = r.f_below[i + 1], f_sw = r.f_below[i - 1];
      const double g_e = r.g[i + 1], g_w = r.g[i - 1], g_n = r.g_above[i], g_s = r.g_below[i];
      const double k_e = r.k[i + 1], k_w = r.k[i - 1], k_n = r.k_above[i], k_s = r.k_below[i];
      const double gx = sx * cell.x, ky = sy * cell.y;
      const double f00 = r.f[i], f10 = right ? f_e : f_w, f01 = up ? f_n : f_s;
      const double f_up = right ? f_ne : f_nw, f_down = right ? f_se : f_sw;
      const double f11 = up ? f_up : f_down;
      const double g00 = gx * r.g[i], g10 = gx * (right ? g_e : g_w), g01 = gx * (up ? g_n : g_s);
      const double k00 = ky * r.k[i], k10 = ky * (right ? k_e : k_w), k01 = ky * (up ? k_n : k_s);
      const double c30 = (g00 + g10) - 2. * (f10 - f00), c20 = 3. * (f10 - f00) - (2. * g00 + g10);
      const double c03 = (k00 + k01) - 2. * (f01 - f00), c02 = 3. * (f01 - f00) - (2. * k00 + k01);
      const double gd = g01 - g00, kd = k10 - k00;
      const double c11 = gd + kd - ((f00 - f01) - (f10 - f11)), c12 = gd - c11, c21 = kd - c11;
      return {((c30 * x + c20 + c21 * y) * x + g00 + c11 * y) * x +
                  ((c03 * y + c02 + c12 * x) * y + k00) * y + f00,
              sx * ((3. * c30 * x + 2. * (c20 + c21 * y)) * x + g00 + (c11 + c12 * y) * y),
              sy * ((3. * c03 * y + 2. * (c02 + c12 * x)) * y + k00 + (c11 + c21 * x) * x)};
    }

    void type_a_row(const TypeARows &r, const VelocityRows &w, int count, StepInCells dt,
                    CellSize cell)
    {
      const double per_x = 1. / cell.x, per_y = 1. / cell.y;
#pragma omp simd
      for (int i = 0; i < count; ++i)
      {
        const Departure d = departure(w, i, dt);
        const Profile p = type_a(r, i, d, cell);
        r.new_f[i] = p.f;
        r.new_g[i] = per_x * (d.xx * p.g + d.yx * p.k);
        r.new_k[i] = per_y * (d.xy * p.g + d.yy * p.k);
      }
    }
  } // namespace

  void cip_type_a(const CipFields &a, const Velocity &velocity, double dt, const Mesh &mesh)
  {
    const CellSize cell{mesh.spacing[0], mesh.spacing[1]};
#pragma omp parallel for schedule(static)
    for (int j = 0; j < mesh.nodes[1]; ++j)
      type_a_row({a.f->row(j - 1), a.f->row(j), a.f->row(j + 1), a.x->row(j - 1), a.x->row(j),
                  a.x->row(j + 1), a.y->row(j - 1), a.y->row(j), a.y->row(j + 1), a.new_f->row(j),
                  a.new_x->row(j), a.new_y->row(j)},
                 velocity_rows(velocity, j), mesh.nodes[0], {dt / cell.x, dt / cell.y}, cell);
  }
} // namespace medium
