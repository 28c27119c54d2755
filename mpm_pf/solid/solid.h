// The solid by the explicit material point method: Eqs. (4)-(6), plane strain with sigma_zz kept.
//
//   rho dv/dt = div sigma + rho b                                              Eq. (4)
//
// Points carry mass, velocity and stress; the domain's square cells serve as the grid on which
// Eq. (4) is solved. What runs here differs from the paper's uGIMP + FLIP, which locks when coarse
// and tears when fine: quadratic B-splines made interpolating where material is held, an affine
// transfer, and cell-averaged volumetric strain rates with relaxed pressures (see
// shape_functions.h, transfer.h, anti_locking.h). This header is all that the world, the recorder
// and the time loop need; the parts are in the other headers of this room.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "medium/numerical_error.h"
#include "record/writer.h"
#include "scene/scene.h"
#include "scene/units.h"

namespace solid
{
  using scene::Point;

  /// With step, time and place, which stand in the message, too.
  struct NumericalError : medium::NumericalError
  {
    NumericalError(const std::string &cause, long step, double time, const Point &place);
    long step;
    double time;
    Point place;
  };

  struct Solid; // everything that moves: defined in body.h, needed by this room only
  struct Deleter
  {
    void operator()(Solid *) const;
  };
  using Owner = std::unique_ptr<Solid, Deleter>;

  /// Points, grid, supports, loads and tracers of a scene with [solid]. `threads`: OpenMP threads
  /// to use (the bits do not depend on it). Throws scene::BadScene: cells not square, no point in a
  /// body, a support or traction that touches nothing, `mach` without any motion to refer it to.
  Owner make_solid(const scene::Scene &, int threads = 1);

  // --- moving ------------------------------------------------------------------------------------

  /// Largest stable step now: step_fraction dx / (c_p + largest speed of a point or support).
  double stable_step(const Solid &);

  /// Displacement over a call divided by its duration, on the nodes of the domain, x fastest,
  /// (cells[0] + 1) x (cells[1] + 1). mass: time mean over the call; 0 where no material came.
  struct NodalVelocity
  {
    std::vector<double> x, y, mass;
  };

  /// Move by dt, in as many equal steps as the limit asks. If `mean` is given it is filled with the
  /// mean nodal velocity. Throws NumericalError: not finite, energy from nothing, a point out of
  /// the mesh or turned inside out.
  void advance(Solid &, double dt, NodalVelocity *mean = nullptr);

  double time(const Solid &);
  long steps(const Solid &);           // taken so far, a restart included
  long points(const Solid &);          // material points
  double largest_speed(const Solid &); // of any point, as of the last step
  long cells(const Solid &);           // grid cells with nodes in use
  /// Bytes: "points" (state), "grid", "scratch" (sorting and the like), and of what is there
  /// "supports" (with the lines of symmetry sides and walls), "tractions", "body force", "tracers"
  /// (of the outline).
  std::map<std::string, double> memory(const Solid &);
  /// Seconds of CPU by part: "points to nodes", "nodes", "nodes to points", "sorting".
  std::vector<record::Profile::Part> profile(const Solid &);
  /// The density that is used, scaled if `mach` was given, and what follows from it.
  struct DensityScaling
  {
    double density = 0., scale = 1.; // as used; over the scene's
    double wave_speed = 0.;
    double reference_speed = 0.; // 0: nothing drives the solid
    double mach() const { return reference_speed / wave_speed; }
  };
  DensityScaling density_scaling(const Solid &);

  // --- observing: every value in the scene's units, stresses are Cauchy
  // -----------------------------

  /// One row of `of` (names of scene/quantities.h) per sample. Stresses, strains, yielded,
  /// jacobian: area-weighted mean over the square bin around the position (each point a square of
  /// its area); displacement and velocity: linear least squares of the points around. NaN where no
  /// material is. In the material frame positions are initial ones.
  record::LineSample sample_line(const Solid &, const scene::LineProbe &,
                                 const std::vector<std::string> &of);
  /// One row; as a line of one position, and at the cost of the points round it.
  std::vector<double> sample_point(const Solid &, const scene::PointProbe &,
                                   const std::vector<std::string> &of);
  /// One row: means weighted with current area over all material or over that which started in the
  /// box; "area" is the sum. NaN if the region holds no point.
  std::vector<double> region_means(const Solid &, const scene::RegionProbe &,
                                   const std::vector<std::string> &of);
  /// Material outline: closed polylines through the tracers.
  std::vector<scene::Polyline> material_outline(const Solid &);
  /// The points with the fields `of` (empty: all of scene/quantities.h), and initial_x, initial_y.
  record::Snapshot snapshot(const Solid &, const std::vector<std::string> &of);

  /// What one support has done. impulse: time integral of the force which it exerts on the material
  /// since the start (so any two samples give their mean force); force: its mean over the last call
  /// of advance; displacement: of the support itself, at the middle of what it holds.
  struct Reaction
  {
    Point impulse = Point::Zero(), force = Point::Zero(), displacement = Point::Zero();
  };
  /// Throws std::out_of_range for a name that no support has.
  Reaction reaction(const Solid &, const std::string &support);

  /// Columns for a HistoryProbe, always in the same order: kinetic_energy, elastic_energy,
  /// plastic_dissipation, external_work, transfer_loss (numerical dissipation of the transfers
  /// between points and grid), energy_balance (what is unaccounted for: work + start - kinetic -
  /// elastic - dissipated - lost by transfers), momentum_x, momentum_y, area, mass, largest_speed,
  /// kinetic_to_internal.
  struct History
  {
    std::vector<std::string> names;
    std::vector<scene::Dimension> dimensions;
    std::vector<double> row;
  };
  History history(const Solid &);
  /// transfer_loss and energy_balance as parts of the largest sum of start and |external_work| so
  /// far.
  struct LostEnergy
  {
    double transfer = 0., unaccounted = 0.;
  };
  LostEnergy lost_energy(const Solid &);
  /// Kinetic energy over what the stresses hold or have dissipated, both as means over the time
  /// since the start; 0 where nothing was strained.
  double mean_kinetic_share(const Solid &);

  // --- going on later
  // ------------------------------------------------------------------------------

  /// Full state, exact bits; put into a solid made from the same scene it continues to the same
  /// bits.
  using Checkpoint = std::map<std::string, std::vector<double>>;
  Checkpoint checkpoint(const Solid &);
  /// The same, one array at a time.
  void checkpoint(const Solid &,
                  const std::function<void(const std::string &, std::vector<double>)> &put);
  void restore(Solid &, const Checkpoint &); // throws std::runtime_error if it is of another scene
} // namespace solid
