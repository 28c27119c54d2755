// CIP advection in two dimensions: a cubic profile on the upwind cell, shifted.
//
// Type A (Yabe and Aoki 1991): from f, g = df/dx, k = df/dy at the corners of the upwind cell, a
// polynomial of ten coefficients; f, g, k are its value and derivatives at (-u dt, -v dt).
// Hermite: the full bicubic of f, g, k and the mixed derivative; 40 to 50 % less error for one more
// field. Both are third order while the field is smooth on the mesh, and stable up to one cell a
// step along an axis (type A on the diagonal only to about a half).
//
// The departure point is x + xi with xi = -v dt + 1/2 dt^2 (v . grad) v, second order in dt, so
// that a turning field does not spiral outwards. The gradients' own sources, dg/dt = -g u_x - k v_x
// and dk/dt = -g u_y - k v_y, are the Jacobian of that map, I - dt A + 1/2 dt^2 A^2, A = grad v by
// centred differences: they turn the gradients with a rotation and stretch them with a strain.
#pragma once

#include "medium/advection.h"

namespace medium
{
  /// Fields read (with ghosts) and written (nodes only) by one step. The gradients are those that
  /// `last` had: what has changed f since then is differenced on the way. The mixed derivative is
  /// null for type A.
  struct CipFields
  {
    const Field<double> *f, *last, *x, *y, *xy;
    Field<double> *new_f, *new_x, *new_y, *new_xy;
  };

  /// One step of type A at all nodes. Shapes: nodal fields on `mesh`; dt in time. Returns the
  /// largest of |u| dt/dx and |v| dt/dy.
  double cip_type_a(const CipFields &, const Velocity &, double dt, const Mesh &);
  /// One step of the bicubic Hermite form; the same.
  double cip_hermite(const CipFields &, const Velocity &, double dt, const Mesh &);
} // namespace medium
