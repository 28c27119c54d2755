// What a run would do and what it would cost, before it does it.
#pragma once

#include <string>

#include "scene/scene.h"
#include "world.h"

/// Which modules are on and from which line, which are off; a few lines, printed at every start.
std::string banner(const scene::Scene &);

/// One line about a world that has just been built: cells, points, steps to the scene's end,
/// memory. What a step takes is known only once one was made: --plan makes some, a run says it as
/// it goes.
std::string size(const World &);

/// The banner and the forecast (forecast.h): cells, points, steps, memory and time by module.
/// Writes nothing. Throws scene::BadScene.
std::string plan(const scene::Scene &, int threads, bool force);
