// Advection of a nodal field: df/dt + v . grad f = 0, and the choices of scheme.
//
//   cip          constrained interpolation profile, type A (Yabe and Aoki, Comput. Phys. Commun.
//   66,
//                219, 1991): f and its two gradients are carried; cip.h
//   cip_hermite  bicubic Hermite form of it: also the mixed derivative; cip.h
//   weno5        fifth-order WENO differences, third-order TVD Runge-Kutta; eulerian.h
//   upwind       first order, as the yardstick of smearing; eulerian.h
//
// The CIP gradients must follow everything else that changes f, above all growth (the other half of
// the operator splitting): g += centred difference of the change. Differences are linear, so this
// is done once, at the next advect(), for the whole change since the last one: growth need not know
// that gradients exist, and a scene without motion has none.
#pragma once

#include "medium/field.h"
#include "scene/scene.h"

namespace medium
{
  /// What CIP keeps beside a field: gradients (field unit per length; xy per length^2, Hermite
  /// only), and the field as the last advection left it.
  struct Gradients
  {
    Field<double> x, y, xy;
    Field<double> last;
    Image image = Image::scalar; // of the field beyond symmetry sides
    std::size_t bytes() const { return x.bytes() + y.bytes() + xy.bytes() + last.bytes(); }
  };

  class Advection
  {
  public:
    Advection(const Mesh &, scene::AdvectionScheme);

    /// Carries `f` with `v` over dt (time). Ghosts of `v` must be filled; those of `f` are filled
    /// here, before and after. Empty gradients are started from centred differences of f, or by
    /// start(). Throws NumericalError if |v| dt exceeds a cell along an axis.
    void advect(Field<double> &f, Gradients &, const Velocity &v, double dt);

    /// Starts the gradients from the given ones (analytic, say); all fields on this mesh. Schemes
    /// that carry none ignore it. `mixed` may be empty: then it is differenced from x and y.
    void start(const Field<double> &f, Gradients &, Field<double> x, Field<double> y,
               Field<double> mixed = {});

    scene::AdvectionScheme scheme() const { return chosen; }
    std::size_t bytes() const;

  private:
    bool carries_gradients() const;
    void check_shift(double shift, double dt) const;
    void advect_cip(Field<double> &f, Gradients &, const Velocity &, double dt);

    Mesh mesh;
    scene::AdvectionScheme chosen;
    Field<double> new_f, new_x, new_y, new_xy; // scratch
  };

  /// Longest shift along an axis, in cells, at which a scheme is stable on the diagonal: the limit
  /// of advect().
  double largest_shift(scene::AdvectionScheme);

  /// Largest of |u|/dx and |v|/dy over the mesh, 1/time: 1/this is the time to cross a cell.
  double crossing_rate(const Velocity &, const Mesh &);
} // namespace medium
