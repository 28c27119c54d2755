// Forces from outside: tractions on the deformed outline and body forces per mass.
//
// A traction is a force per deformed length, f_a = int t N_a |dx/ds| ds; a pressure p acts along
// the inward normal of the deformed side, f_a = int p N_a (-dy/ds, dx/ds) ds (sides run
// counter-clockwise around the material). Both change with their side, so they have a (not
// symmetric) stiffness. A body force is an acceleration; the mass in it is that of the initial
// volume, rho = rho0/J, hence f_a = int rho0 b N_a dV0. Both are expressions of X, the current x
// and t; the dependence of an expression on x is left out of the tangent.
#pragma once

#include <optional>
#include <vector>

#include "discretisation.h"
#include "scene/expression.h"

namespace fe
{
  struct Loads
  {
    /// Where a load begins or ends inside a side of the mesh only a part of it is loaded.
    struct LoadedSide
    {
      BoundarySide side;
      double from = 0., to = 1.; // of the side's parameter
    };
    struct Traction
    {
      std::vector<LoadedSide> sides;
      std::array<scene::Function, 2> traction;
      std::optional<scene::Function> pressure = {}; // instead of the traction
    };
    std::vector<Traction> tractions;
    std::optional<std::array<scene::Function, 2>> acceleration;
    double density = 0.;

    bool any() const { return acceleration || !tractions.empty(); }
  };

  /// Throws scene::BadScene if a traction acts on no side of the mesh.
  Loads make_loads(const scene::Scene &, const Discretisation &);

  /// Consistent nodal forces (unknowns) at displacements `u` and time `t`, from the cells that this
  /// process owns.
  std::vector<double> external_forces(const Loads &, const Discretisation &,
                                      const std::vector<double> &u, double t);

  /// Stiffness of the tractions on one side: d force / du of the side's nodes, (2 (degree + 1))^2,
  /// row-major, node by node.
  std::vector<double> side_stiffness(const Loads::Traction &, const Loads::LoadedSide &,
                                     const Discretisation &, const std::vector<double> &u,
                                     double t);
} // namespace fe
