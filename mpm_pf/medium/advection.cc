#include "medium/advection.h"

#include <cmath>
#include <sstream>

#include "medium/cip.h"
#include "medium/eulerian.h"
#include "medium/numerical_error.h"
#include "medium/sides.h"

namespace medium
{
  using scene::AdvectionScheme;

  namespace
  {
    /// to = from, ghosts too.
    void copy_rows(const Field<double> &from, Field<double> &to)
    {
      if (to.empty())
      {
        to = from;
        return;
      }
#pragma omp parallel for schedule(static)
      for (int j = -ghost_layers; j < from.nodes(1) + ghost_layers; ++j)
        std::copy(from.row(j) - ghost_layers, from.row(j) + from.nodes(0) + ghost_layers,
                  to.row(j) - ghost_layers);
    }

    void fill_gradient_ghosts(Gradients &g, const Mesh &mesh)
    {
      fill_ghosts(g.x, mesh, Parity::odd_in_x, g.image);
      fill_ghosts(g.y, mesh, Parity::odd_in_y, g.image);
      if (!g.xy.empty())
        fill_ghosts(g.xy, mesh, Parity::odd_in_both, g.image);
    }

    /// Of a field that is its own mirror image one derivative vanishes on the mirror, which upwind
    /// cells to one side of it do not see. Where the motion crosses the side, nothing is mirrored.
    void vanish_on_symmetry_sides(Gradients &g, const Velocity &velocity, double dt,
                                  const Mesh &mesh)
    {
      const bool scalar = g.image == Image::scalar;
      Field<double> &odd_across_x = scalar ? g.x : g.y, &odd_across_y = scalar ? g.y : g.x;
      const StepInCells step{dt / mesh.spacing[0], dt / mesh.spacing[1]};
      const auto is_symmetry = [&](bool here, Edge edge)
      { return here && mesh.side(edge) == Boundary::symmetry; };
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for_mirror_nodes(mesh, j,
                         [&](int i, const MirrorSides &at)
                         {
                           const Departure d = departure(velocity_rows(velocity, j), i, step);
                           if (!crosses(d.x) && (is_symmetry(at.left, Edge::left) ||
                                                 is_symmetry(at.right, Edge::right)))
                             odd_across_x(i, j) = 0.;
                           if (!crosses(d.y) && (is_symmetry(at.bottom, Edge::bottom) ||
                                                 is_symmetry(at.top, Edge::top)))
                             odd_across_y(i, j) = 0.;
                         });
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
    fill_ghosts(gradients.last, mesh, Parity::even, gradients.image);
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

  /// Throws where a step of dt shifts the field by more cells than the scheme can bear.
  void Advection::check_shift(double shift, double dt) const
  {
    if (shift <= largest_shift(chosen) * (1. + 1e-9))
      return;
    std::ostringstream text;
    text << "advection over " << dt << " shifts the field by " << shift
         << " cells along an axis; the scheme is stable up to " << largest_shift(chosen)
         << ": shorten the step (advection.step_fraction or clock.step)";
    throw NumericalError(text.str());
  }

  void Advection::advect_cip(Field<double> &f, Gradients &gradients, const Velocity &velocity,
                             double dt)
  {
    const bool hermite = chosen == AdvectionScheme::cip_hermite;
    fill_ghosts(f, mesh, Parity::even, gradients.image);
    if (gradients.x.empty()) // gradients and all: the first differences are those from zero
    {
      gradients.x = gradients.y = gradients.last = Field<double>(mesh);
      if (hermite)
        gradients.xy = Field<double>(mesh);
    }
    if (new_x.empty())
      new_x = new_y = Field<double>(mesh);
    if (hermite && new_xy.empty())
      new_xy = Field<double>(mesh);
    const CipFields fields{&f,
                           &gradients.last,
                           &gradients.x,
                           &gradients.y,
                           hermite ? &gradients.xy : nullptr,
                           &new_f,
                           &new_x,
                           &new_y,
                           hermite ? &new_xy : nullptr};
    check_shift((hermite ? cip_hermite : cip_type_a)(fields, velocity, dt, mesh), dt);
    keep_fixed_sides(new_f, f, mesh);
    f.swap(new_f);
    gradients.x.swap(new_x);
    gradients.y.swap(new_y);
    gradients.xy.swap(new_xy);
    vanish_on_symmetry_sides(gradients, velocity, dt, mesh);
    fill_ghosts(f, mesh, Parity::even, gradients.image);
    fill_gradient_ghosts(gradients, mesh);
    copy_rows(f, gradients.last);
  }

  void Advection::advect(Field<double> &f, Gradients &gradients, const Velocity &velocity,
                         double dt)
  {
    if (new_f.empty())
      new_f = Field<double>(mesh);
    if (carries_gradients())
      return advect_cip(f, gradients, velocity, dt);
    check_shift(dt * crossing_rate(velocity, mesh), dt);
    fill_ghosts(f, mesh, Parity::even, gradients.image);
    const Field<double> before = f;
    if (chosen == AdvectionScheme::weno5)
    {
      if (new_x.empty())
        new_x = Field<double>(mesh);
      weno5(f, new_f, new_x, velocity, dt, mesh, gradients.image);
    }
    else
      upwind(f, new_f, velocity, dt, mesh);
    keep_fixed_sides(f, before, mesh);
    fill_ghosts(f, mesh, Parity::even, gradients.image);
  }
} // namespace medium
