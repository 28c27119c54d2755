// From displacements to nodal forces, stresses and the tangent of the whole body.
#pragma once

#include <vector>

#include "element.h"
#include "linear_system.h"
#include "loads.h"
#include "supports.h"

namespace fe
{
  /// The body: mesh, law, how it is held and loaded. Fixed after set-up.
  struct Problem
  {
    Discretisation mesh;
    Material material;
    Supports supports;
    Loads loads;
    double tolerance = 1e-9; // of Newton's residual, relative to the largest force so far
    int threads = 1;
  };

  /// An equilibrium (or a guess at one).
  struct State
  {
    double time = 0.;
    std::vector<double> u;                  // unknowns
    std::vector<PointState> points;         // cells x points; of the cells that touch this process
    std::vector<double> internal, external; // nodal forces, whole on every process
    double smallest_jacobian = 1.;          // at integration points
    int worst_cell = 0;                     // where that is
    double force_scale = 0.;                // largest norm of held and external forces so far
  };

  /// Undeformed state with the bodies' initial stress, and its nodal forces.
  State initial_state(const Problem &, const scene::Scene &);

  /// Seconds of work, by part.
  struct Timing
  {
    double assembly = 0., solve = 0.;
    long assemblies = 0, solves = 0;
  };

  /// Nodal forces and stresses at `now.u`, `now.time`, coming from `old`. Returns false if an
  /// element folds (now.smallest_jacobian <= 0; nothing else is then valid). With `system`, its
  /// matrix is set to the tangent with held unknowns reduced to the diagonal, and `correction`
  /// (unknowns) to what the held unknowns' jump `jump` does to the right side; `jump` may be empty.
  struct Tangent
  {
    LinearSystem *system = nullptr;
    std::vector<double> jump, correction;
  };
  bool assemble(const Problem &, const State &old, State &now, Tangent *);

  /// Out-of-balance force of a state: internal minus external (unknowns).
  std::vector<double> residual(const State &);
} // namespace fe
