// Moving walls: pistons that enter the domain from its sides and press on what has grown up to them
// (Sec. 3 of the paper). Adiabatic, without flux of phase, at their true place (cuts.h).
//
// A tip never touches an adiabatic wall at rest, because the heat between them cannot leave; so a
// wall starts when phi = 0 has come within a stated distance (or at a stated time), speeds up
// smoothly, and compression counts from the first contact. Position is an exact integral of the
// speed
//   V s^2 (3 - 2 s), s = (t - start)/ramp < 1;   V afterwards;   0 once the travel is done,
// so it does not depend on the steps taken. With a contact ramp the wall only approaches that way:
// it stops at the first contact and starts once more from rest ("once the arms reach the walls, the
// walls start to move"), so that the contact is no impact.
//
// One coupling step, and why in this order: start_walls() examines phi; move() gives walls their
// new position and velocity, which is the velocity of the material on them, and the solid answers
// to that. The melt's fields are then advected out of the old rectangle, whose continuation behind
// the walls is still in place, and only then does update_cuts() give them the new one: a node that
// a wall has come nearer to than half a spacing is deactivated, the line before it takes over its
// cell, and what the weighted sum of a field loses or wins by that is counted as swept. The sum over
// the active cells plus what was swept is kept to rounding by walls; it changes by advection alone,
// as -v . grad does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "medium/advection.h"
#include "medium/cuts.h"
#include "scene/scene.h"

namespace medium
{
  using scene::WallGrip;

  struct Wall
  {
    scene::Wall asked;
    Edge side;
    WallGrip grip;         // grip: material sticks to it; slip: it slides along it
    double start_distance; // length; negative: by time
    double origin;         // coordinate across the wall before it moved
    double position;       // now
    double velocity = 0.;  // over the present step, along the axis; its material moves with it
    double travel = 0.;    // inward, length
    std::optional<double> started; // time
    std::optional<double> touched; // time of the first contact
    double travel_at_touch = 0.;
    double span_at_touch = 0.; // to the opposite side then, length

    int axis() const { return side == Edge::left || side == Edge::right ? 0 : 1; }
    /// +1 if moving inward raises the coordinate, else -1.
    int inward() const { return side == Edge::left || side == Edge::bottom ? 1 : -1; }
  };

  /// Where the wall stands a time `remaining` before the end of the present step.
  inline double position_before_end(const Wall &wall, double remaining)
  {
    return wall.position - wall.velocity * remaining;
  }

  struct Walls
  {
    std::vector<Wall> walls;
    Cuts cuts;                  // where the fields end: follows the positions in update_cuts()
    double swept_heat = 0.;     // integral of theta lost to the walls, length^2
    double swept_phase = 0.;    // of phi
    const Wall *at(Edge) const; // null where the domain has no wall
    bool moving() const;
  };

  /// The walls of a scene, at rest on the sides of the domain. Throws std::invalid_argument for two
  /// walls on one side, for a wall on a periodic or fixed side, and for walls that would meet.
  Walls make_walls(const std::vector<scene::Wall> &, const Mesh &);

  /// What is a wall's first contact: phi = 0 arriving there, or only the push of material points. A
  /// mere marker of the points is no melt that meets the wall at a right angle, so its profile says
  /// where the edge is but to a cell.
  enum class Contact
  {
    front,
    push
  };

  /// Starts walls that the front has come near to (or whose time has come), and notes first
  /// contacts. phi: ghosts and lines behind walls filled.
  void start_walls(Walls &, const Field<double> &phi, const Mesh &, double time,
                   Contact counted = Contact::front);

  /// The same without a front: only starts walls whose time has come.
  void start_walls(Walls &, double time);

  /// Notes the first contact of a wall that the front has not been seen to touch: points feel a
  /// wall through the nodes that both share, before phi = 0 has come up to it.
  void record_contact(Wall &, const Walls &, const Mesh &, double time);

  /// Moves the walls from `time` to time + dt; sets their velocity to the mean over dt. Throws
  /// NumericalError if a wall crosses more than half a cell at once.
  void move(Walls &, double time, double dt, const Mesh &);

  /// Largest step over which no wall crosses more than `fraction` of a cell; infinity once all
  /// have travelled.
  double step_limit(const Walls &, const Mesh &, double fraction);

  /// A field that ends at the walls; gradients may be null. `swept`, if not null, is raised by what
  /// its integral loses.
  struct WalledField
  {
    Field<double> *value;
    Gradients *gradients;
    double *swept;
  };

  /// Lets the fields' rectangle follow the walls, counts what is swept, and continues every field
  /// and its gradients behind the walls. To be called after advection, and once at the start of a
  /// run.
  void update_cuts(Walls &, const Mesh &, const std::vector<WalledField> &);

  /// The velocity behind the walls, before advection: across a wall it runs linearly through the
  /// wall's own, along it evenly (slip) or through zero (grip). Ghosts are filled.
  void fill_behind(Velocity &, const Walls &, const Mesh &);

  /// Distance from a wall to phi = 0 along its normal, at most `reach` (length); 0 in contact;
  /// empty if the front is further away.
  std::optional<double> gap_to_front(const Wall &, const Cuts &, const Field<double> &phi,
                                     const Mesh &, double reach);

  /// Inward travel of all walls of one axis since each first touched, over the span at the first
  /// touch; the larger of both axes. 0 before.
  double compression(const Walls &);
  /// Time from `time` on until it is `wanted`, at most `longest`: `longest` if that is further
  /// away, or reached already.
  double time_to_compression(const Walls &, double time, double wanted, double longest);

  /// Memory held by the walls; what they fill behind them belongs to the fields.
  std::size_t bytes(const Walls &);

  /// State for a checkpoint, exact bits, and back into walls made from the same scene.
  std::vector<double> pack(const Walls &);
  void unpack(Walls &, const std::vector<double> &);
} // namespace medium
