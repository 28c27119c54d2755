// Distance and extension by differential equations, as in the paper (Refs. [13]-[15]): the choice
// `method = "pde"`, first in line of descent and slower than the closest point.
//
//   psi_tau + S(psi0) (|grad psi| - 1) = 0        psi0 = sqrt(2) W0 atanh(phi)
//   q_tau - n . grad q = 0  in the liquid,        n = grad psi/|grad psi|, into the solid
//
// The first: Godunov's Hamiltonian with second-order ENO differences, second-order TVD Runge-Kutta,
// and the subcell fix of Russo and Smereka (J. Comput. Phys. 163, 51, 2000) at nodes next to the
// contour, which otherwise drifts: there psi relaxes to psi0/|grad psi0|. The second: first-order
// upwind differences. Both run in the tiles of the band only, until the news have crossed it.
#pragma once

#include "medium/distance.h"

namespace medium
{
  /// Replaces psi in the band by the solution of the first equation, starting from `phi` (ghosts
  /// filled) with front width W0 (length). The pieces and who is nearest to which stay.
  template <class T>
  void reinitialise(Distance &, const Field<T> &phi, double front_width, const Mesh &);

  /// Marches `field` in the band's liquid (less than `depth` below the contour, or without
  /// `material`) to rest; its values there are the start.
  void march_extension(Field<double> &field, const Distance &, const Field<unsigned char> &material,
                       double depth, const Mesh &);
} // namespace medium
