#include "medium/advection.h"

#include <cmath>
#include <sstream>

#include "medium/cip.h"
#include "medium/eulerian.h"
#include "medium/trouble.h"

namespace medium
{
  using scene::AdvectionScheme;

  namespace
  {
    /// Three rows of a field round the one in hand.
    struct RowsOf
    {
      RowsOf(const Field<double> &f, int j)
          : below(f.row(j - 1)), here(f.row(j)), above(f.row(j + 1))
      {
      }
      const double *below, *here, *above;
    };

    /// x, y += centred differences of (now - before) on one row.
    void add_slopes(const RowsOf &now, const RowsOf &before, int count, double per_x, double per_y,
                    double *x, double *y)
    {
#pragma omp simd
      for (int i = 0; i < count; ++i)
      {
        x[i] += per_x *
                ((now.here[i + 1] - now.here[i - 1]) - (before.here[i + 1] - before.here[i - 1]));
        y[i] += per_y * ((now.above[i] - now.below[i]) - (before.above[i] - before.below[i]));
      }
    }

    /// xy += centred mixed difference of (now - before) on one row.
    void add_twists(const RowsOf &now, const RowsOf &before, int count, double per_xy, double *xy)
    {
#pragma omp simd
      for (int i = 0; i < count; ++i)
        xy[i] += per_xy *
                 (((now.above[i + 1] - now.above[i - 1]) - (now.below[i + 1] - now.below[i - 1])) -
                  ((before.above[i + 1] - before.above[i - 1]) -
                   (before.below[i + 1] - before.below[i - 1])));
    }

    /// Gradients += centred differences of (now - before).
    void add_differences(const Field<double> &now, const Field<double> &before, Gradients &target,
                         const Mesh &mesh)
    {
      const double per_x = 0.5 / mesh.spacing[0], per_y = 0.5 / mesh.spacing[1];
#pragma omp parallel for schedule(static)
      for (int j = 0; j < mesh.nodes[1]; ++j)
      {
        const RowsOf new_rows(now, j), old_rows(before, j);
        add_slopes(new_rows, old_rows, mesh.nodes[0], per_x, per_y, target.x.row(j),
                   target.y.row(j));
        if (!target.xy.empty())
          add_twists(new_rows, old_rows, mesh.nodes[0], per_x * per_y, target.xy.row(j));
      }
    }

    void fill_gradient_ghosts(Gradients &g, const Mesh &mesh)
    {
      fill_ghosts(g.x, mesh, Parity::odd_in_x);
      fill_ghosts(g.y, mesh, Parity::odd_in_y);
      if (!g.xy.empty())
        fill_ghosts(g.xy, mesh, Parity::odd_in_both);
    }

    void keep_fixed_sides(Field<double> &next, const Field<double> &last, const Mesh &mesh)
    {
      const int nx = mesh.nodes[0], ny = mesh.nodes[1];
      for (int j = 0; j < ny; ++j)
      {
        const bool all = (j == 0 && mesh.side(Edge::bottom) == Boundary::fixed) ||
                         (j == ny - 1 && mesh.side(Edge::top) == Boundary::fixed);
        if (all)
          std::copy(last.row(j), last.row(j) + nx, next.row(j));
        if (mesh.side(Edge::left) == Boundary::fixed)
          next(0, j) = last(0, j);
        if (mesh.side(Edge::right) == Boundary::fixed)
          next(nx - 1, j) = last(nx - 1, j);
      }
    }
  } // namespace

  double largest_shift(const AdvectionScheme scheme)
  {
    return scheme == AdvectionScheme::cip_hermite ? 1. : 0.5;
  }

  double crossing_rate(const Velocity &velocity, const Mesh &mesh)
  {
    const double per_x = 1. / mesh.spacing[0], per_y = 1. / mesh.spacing[1];
    double rate = 0.;
#pragma omp parallel for schedule(static) reduction(max : rate)
    for (int j = 0; j < mesh.nodes[1]; ++j)
    {
      const double *u = velocity.x.row(j), *v = velocity.y.row(j);
      for (int i = 0; i < mesh.nodes[0]; ++i)
        rate = std::max({rate, std::abs(u[i]) * per_x, std::abs(v[i]) * per_y});
    }
    return rate;
  }

  Advection::Advection(const Mesh &m, AdvectionScheme scheme) : mesh(m), chosen(scheme) {}

  std::size_t Advection::bytes() const
  {
    return new_f.bytes() + new_x.bytes() + new_y.bytes() + new_xy.bytes();
  }

  bool Advection::carries_gradients() const
  {
    return chosen == AdvectionScheme::cip || chosen == AdvectionScheme::cip_hermite;
  }

  void Advection::start(const Field<double> &f, Gradients &gradients, Field<double> x,
                        Field<double> y, Field<double> mixed)
  {
    if (!carries_gradients())
      return;
    gradients.x = std::move(x);
    gradients.y = std::move(y);
    gradients.last = f;
    fill_ghosts(gradients.last, mesh);
    fill_gradient_ghosts(gradients, mesh);
    if (chosen == AdvectionScheme::cip)
      return;
    gradients.xy = std::move(mixed);
    if (gradients.xy.empty())
    {
      gradients.xy = Field<double>(mesh);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          gradients.xy(i, j) =
              0.25 * ((gradients.x(i, j + 1) - gradients.x(i, j - 1)) / mesh.spacing[1] +
                      (gradients.y(i + 1, j) - gradients.y(i - 1, j)) / mesh.spacing[0]);
    }
    fill_gradient_ghosts(gradients, mesh);
  }

  /// Brings the gradients up to date with whatever changed f since the last advection.
  void Advection::catch_up(Field<double> &f, Gradients &gradients) const
  {
    fill_ghosts(f, mesh);
    if (gradients.x.empty())
    {
      gradients.x = gradients.y = gradients.last = Field<double>(mesh);
      if (chosen == AdvectionScheme::cip_hermite)
        gradients.xy = Field<double>(mesh);
    }
    add_differences(f, gradients.last, gradients, mesh); // at first from zero
    fill_gradient_ghosts(gradients, mesh);
  }

  void Advection::advect_cip(Field<double> &f, Gradients &gradients, const Velocity &velocity,
                             double dt)
  {
    catch_up(f, gradients);
    if (new_x.empty())
      new_x = new_y = Field<double>(mesh);
    const bool hermite = chosen == AdvectionScheme::cip_hermite;
    if (hermite && new_xy.empty())
      new_xy = Field<double>(mesh);
    const CipFields fields{&f,     &gradients.x, &gradients.y, &gradients.xy,
                           &new_f, &new_x,       &new_y,       &new_xy};
    if (hermite)
      cip_hermite(fields, velocity, dt, mesh);
    else
      cip_type_a(fields, velocity, dt, mesh);
    keep_fixed_sides(new_f, f, mesh);
    f.swap(new_f);
    gradients.x.swap(new_x);
    gradients.y.swap(new_y);
    gradients.xy.swap(new_xy);
    fill_ghosts(f, mesh);
    gradients.last = f;
  }

  void Advection::advect(Field<double> &f, Gradients &gradients, const Velocity &velocity,
                         double dt)
  {
    const double shift = dt * crossing_rate(velocity, mesh);
    if (!(shift <= largest_shift(chosen) * (1. + 1e-9)))
    {
      std::ostringstream text;
      text << "advection over " << dt << " shifts the field by " << shift
           << " cells along an axis; the scheme is stable up to " << largest_shift(chosen)
           << ": shorten the step (advection.step_fraction or clock.step)";
      throw NumericalTrouble(text.str());
    }
    if (new_f.empty())
      new_f = Field<double>(mesh);
    if (carries_gradients())
      return advect_cip(f, gradients, velocity, dt);
    fill_ghosts(f, mesh);
    const Field<double> before = f;
    if (chosen == AdvectionScheme::weno5)
    {
      if (new_x.empty())
        new_x = Field<double>(mesh);
      weno5(f, new_f, new_x, velocity, dt, mesh);
    }
    else
      upwind(f, new_f, velocity, dt, mesh);
    keep_fixed_sides(f, before, mesh);
    fill_ghosts(f, mesh);
  }
} // namespace medium
