// Probes of a forecast: parts of the world set in motion for some hundredths of a second and timed.
#pragma once

#include <cstddef>
#include <functional>

#include "forecast.h"
#include "world.h"

inline constexpr double probe_budget_s = 0.04; // CPU seconds of each probe
inline constexpr int probe_calls = 400;        // at most

/// CPU seconds of one call: after a first one that warms up, as many as `budget` holds, at most
/// `most`; the mean of the quickest quarter of them.
double seconds_of(const std::function<void()> &call, double budget, int most);

/// CPU seconds of one pass a = b + s c over `nodes` doubles, per node: the unit of the kernels.
double triad_seconds(std::size_t nodes);

/// Cells that what drives the solid crosses in a coupling step of that length.
double shift_of_a_step(const World &, double step);

/// Length of a growth step as it will be taken. Time.
double growth_step_taken(const World &);

/// CPU seconds of one step of growth or of heat alone, as the world stands. Moves it.
double seconds_per_growth_step(World &);

/// What an imposed motion carries until `end`; nothing where nothing moves. Moves the world.
void forecast_advection(World &, double end, Forecast &);

/// All of a scene with [growth]: the crystal, what is carried, the solid that a wall will press.
/// `triad`: of this machine and mesh, CPU seconds a node. Moves the world.
void forecast_crystal(World &, double triad, Forecast &);
