// Tractions on the outline and body forces.
//
// A traction acts on the chords between tracers, per current length, integrated with two Gauss
// points each; a pressure acts along a chord's inward normal (material lies to the left). A node
// takes its share by the shape functions and by what the points can balance there (edge_shares.h);
// shares are scaled to the whole force. Where a load ends inside an edge the outline gets a tracer,
// so that the loaded length is exact.
#pragma once

#include <optional>
#include <string>

#include "scene/expression.h"
#include "solid/edge_shares.h"

namespace solid
{
  struct Load
  {
    std::string name;
    std::array<scene::Function, 2> traction;
    std::optional<scene::Function> pressure; // instead of the traction
  };

  struct Loads
  {
    std::vector<Load> tractions;
    struct NodalForce
    {
      std::ptrdiff_t node;
      Point force;
    };
    std::vector<NodalForce> nodal_forces; // of this step, for their work
    std::vector<Point> on_grips;          // forces of this step that rigid grips take, by grip
    EdgeShares shares;
    std::optional<Point> parted; // where a loaded edge started that no material is near any more
    std::optional<std::array<scene::Function, 2>> body_force;
    Acceleration acceleration; // of the masses as used
    double true_mass = 1.;     // over the mass as used: a body of scaled density weighs no more
    double work = 0., work_done = 0.; // since the start; sum of absolute values
  };

  struct Solid; // body.h

  /// Marks the tracers of loaded chords. Throws scene::BadScene for a traction that touches
  /// nothing.
  Loads make_loads(const scene::Scene &, Tracers &);

  /// Accelerations of the points at time t.
  void evaluate_body_force(Loads &, const Points &, const Fraction &, double t);

  /// Add the tractions at the solid's time to the nodal forces.
  void apply_tractions(Solid &);

  /// Add the work of tractions over dt, with the mean of the nodes' velocities before and after.
  void add_traction_work(Loads &, const Grid &, double dt);
  /// Add the work of body forces over dt with the points' velocities as they are now.
  void add_body_force_work(Loads &, const Points &, double dt);
} // namespace solid
