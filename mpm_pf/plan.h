// What a run would do and what it would cost, before it does it.
#pragma once

#include <string>

#include "scene/scene.h"

/// Which modules are on and from which line, which are off; a few lines, printed at every start.
std::string banner(const scene::Scene &);

/// The banner and the forecast (forecast.h): cells, points, steps, memory and time by module.
/// Writes nothing. Throws scene::BadScene.
std::string plan(const scene::Scene &, int threads);
