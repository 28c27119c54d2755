// Section 2 of the paper on one page: the time loop.
#pragma once

#include <functional>

#include "recorder.h"
#include "world.h"

/// Advance the world by dt: walls, solid, extension into the melt, advection, growth and heat.
void step(World &world, double dt);

/// Run to the scene's end, observing as the probes ask. Before the first step and after every one
/// `after_step` is called; it returns false to stop (interrupted). Returns whether the end was
/// reached. Throws what step() throws.
bool simulate(World &world, Recorder &recorder,
              const std::function<bool(const World &)> &after_step);
