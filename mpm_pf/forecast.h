// What a run will cost, predicted before it: for --plan, and for the campaign, which holds what was
// predicted against what was measured.
//
// Nothing here is a machine's constant: the world is built as the run would build it, set in motion
// for some hundredths of a second, and what a step of each module costs on this machine is read off
// its clock. What the first steps cannot show (a crystal that is still a seed, points that are
// seeded when a wall arrives) is counted from the crystal's size, forecast_growth.h.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

struct Forecast
{
  std::map<std::string, double> counts;  // "points", "cells", "nodes", "steps", "growth steps", ...
  std::map<std::string, double> bytes;   // by module, at the end of the run
  std::map<std::string, double> seconds; // of CPU: "set-up", "solid", "growth", "advection"
  double resident_bytes = 0.;

  double solver_bytes() const;
  double cpu_s() const;
};

/// Builds the world and moves it a little; writes nothing. Throws scene::BadScene.
Forecast make_forecast(const scene::Scene &, int threads, bool force = false);

/// The forecast for people, and one line that programs read:
/// `forecast cpu_s=... solver_bytes=... resident_bytes=...`.
std::string describe(const Forecast &);
