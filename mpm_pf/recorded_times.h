// When a run must stop for a look: steps are cut short to end there.
#pragma once

#include <string>
#include <vector>

#include "reaction_window.h"
#include "scene/scene.h"

/// A reaction to be recorded: of a probe, or unasked of a support that no probe names.
struct AskedReaction
{
  std::string name, support;
  ReactionSampling sampling;
};
std::vector<AskedReaction> asked_reactions(const scene::Scene &);

/// All times in [0, clock.end] at which a probe samples, or a window of a reaction begins or ends;
/// sorted, and no two nearer than a billionth of the end. Without samples at compressions.
std::vector<double> recorded_times(const scene::Scene &);

/// Sorted, without what is nearer than `tolerance` to the one before.
std::vector<double> apart_by(double tolerance, std::vector<double> times);
