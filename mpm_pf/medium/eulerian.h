// Advection schemes without gradients: WENO5 with three Runge-Kutta stages, and first-order upwind.
//
//   df/dt = -u f_x - v f_y, non-conservative as in Eqs. (1) to (3): the extended velocity of the
//   liquid is not free of divergence.
//
// WENO5: upwind-biased fifth-order differences of f (Jiang and Peng, SIAM J. Sci. Comput. 21, 2126,
// 2000), third-order TVD Runge-Kutta (Shu and Osher 1988). The velocity is that of the step's
// start.
#pragma once

#include "medium/field.h"

namespace medium
{
  /// One step of dt at all nodes. `f` is read with ghosts and replaced; `first`, `second` are
  /// scratch of the same shape. Stable up to |u| dt/dx + |v| dt/dy = 1.
  void weno5(Field<double> &f, Field<double> &first, Field<double> &second, const Velocity &,
             double dt, const Mesh &, Image = Image::scalar);

  /// One step of dt; `next` is scratch. Stable up to |u| dt/dx + |v| dt/dy = 1.
  void upwind(Field<double> &f, Field<double> &next, const Velocity &, double dt, const Mesh &);
} // namespace medium
