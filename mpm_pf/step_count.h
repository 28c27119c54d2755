// How many steps a run takes, with those that are cut short to end where something is recorded.
#pragma once

#include "world.h"

struct StepCount
{
  double couplings = 0., // calls of step()
      substeps = 0.;     // steps of `substep` at most within them
};

/// Steps from time `from` to `to` if each call of step() is as long as `coupling` and each step
/// within it as `substep`, but for those that end at a recorded time. Times.
StepCount count_steps(const World &, double from, double to, double coupling, double substep);

/// The same of the whole run, with the steps of its solid as they are now.
StepCount count_solid_steps(const World &);
