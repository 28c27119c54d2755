// One element: nodal forces and their exact derivative, free of volumetric locking.
//
// Large plastic flow keeps volume, so a full-order element is over-constrained and locks (fully
// integrated linear quadrilaterals carry 20 to 45 % too much force in the sheared bar). Reduced
// integration of the nine-node element cures it, but leaves zero-energy modes that neighbours
// share. We take the dilatation from a smaller space instead: quadratic displacements with volume
// ratios linear in each element (Q2/P-1, inf-sup stable, third order in displacement), or linear
// displacements with constant volume ratios (Q1/P0). With J the volume ratio at a point and
// Jt its projection onto that space (weights of the initial volume), the law sees
//
//     Ft = (Jt/J)^(1/2) F,
//
// the in-plane form of the F-bar method, and the nodal forces are those conjugate to it: with
// p = (sigma_xx + sigma_yy)/2 of the law's stress and pt its projection,
//
//     force_a = sum_q w_q [ Jt dev(sigma) + J pt 1 ] grad N_a,      dev: in the plane.
//
// Everything refers to the initial mesh (total Lagrangian bookkeeping of an incremental law): the
// relative deformation of a step, f = Ft_{n+1} Ft_n^-1, is the same as from a mesh moved with the
// material, but the reference gradients are computed once. The projection is of rank one or three,
// so its share of the tangent is a few outer products per element and nothing is condensed.
// Sources: E. A. de Souza Neto et al., Int. J. Solids Struct. 33 (1996) 3277; J. C. Simo, R. L.
// Taylor, K. S. Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177.
#pragma once

#include "material_tangent.h"

namespace fe
{
  /// Tables of one element on the initial mesh, row-major. gradient: points x nodes x 2 [1/length];
  /// weight: points [area]; mode: points x modes, orthonormal in these weights.
  struct ElementTables
  {
    const double *gradient, *weight, *mode;
  };

  /// What the element is asked for. displacement: 2 x nodes, node by node; old, now: points;
  /// force: 2 x nodes; tangent: (2 nodes)^2 row-major or null.
  struct ElementRequest
  {
    const double *displacement;
    const PointState *old;
    PointState *now;
    double *force, *tangent;
    double dt;
  };

  /// Evaluate one element of degree 1 or 2 (4 nodes, 4 points, 1 mode; 9, 9, 3). Returns the
  /// smallest volume ratio at its integration points; if that is not positive, nothing else is
  /// valid.
  double evaluate_element(int degree, const Material &, const ElementTables &,
                          const ElementRequest &);
} // namespace fe
