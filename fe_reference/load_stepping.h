// From time 0 to the end in load increments that shrink when Newton fails and grow back.
//
// The nominal increment is clock.end / fe.load_steps; it is never exceeded, because the radial
// return and the polar update are accurate to second order in it. The guess of an increment is the
// last velocity carried on, which in steady plastic flow is nearly right; where that fails (the
// load turns round) the increment is tried again from rest, then halved. Sampling times are met
// exactly.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "newton.h"

namespace fe
{
  /// Work done so far, per unit depth.
  struct Energies
  {
    double external = 0., elastic = 0., plastic = 0.;
  };

  /// What the march carries from one increment to the next, beside the equilibrium itself.
  struct SteppingState
  {
    std::vector<double> velocity; // unknowns; empty: at rest
    double increment = 0.;        // next one to try; 0: the nominal one
    int easy_increments = 0;      // increments since the last difficulty
    int steps = 0, retries = 0, iterations = 0;
    Energies energies;
  };

  /// An accepted increment, handed to the observer. `state` and `before` belong to its two ends;
  /// they are the same for the state from which the march starts.
  struct Step
  {
    const State &state, &before;
    const SteppingState &stepping;
    NewtonReport newton;
  };

  struct SteppingOptions
  {
    double end = 0.; // time at which to stop
    int load_steps = 100;
    std::vector<double> sampling_times; // sorted
    bool until_folding = false;         // go on past `end` until the mesh has folded
    std::function<void(const Step &)> observe;
    std::function<bool()> folded;      // by the last observed state, more than may be overlooked
    std::function<bool()> interrupted; // the same answer on every process
    // Why the last observed state is none of this body; empty text or function: it is.
    std::function<std::string()> refused = {};
  };

  struct Outcome
  {
    enum class Kind
    {
      complete,
      diverged,
      interrupted
    } kind = Kind::complete;
    std::string message; // time, step, place, reason and remedy where no equilibrium was found
    State last;          // last equilibrium
    SteppingState stepping;
    std::optional<double> unstable_since; // time of the first of two unstable equilibria in a row
  };

  /// March from `initial`, an equilibrium. `stepping` is that of an earlier run which goes on here.
  Outcome run_load_steps(const Problem &, LinearSystem &, State initial, const SteppingOptions &,
                         SteppingState stepping = {});

  /// Elastic energy and plastic work of a state, whole on every process.
  Energies stored_energies(const Problem &, const State &);
} // namespace fe
