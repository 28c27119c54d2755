#include "recorded_times.h"

#include <algorithm>
#include <set>

#include "scene/schedule.h"

std::vector<double> apart_by(const double tolerance, std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(),
                          [&](double a, double b) { return b - a <= tolerance; }),
              times.end());
  return times;
}

std::vector<AskedReaction> asked_reactions(const scene::Scene &scene)
{
  const double end = scene.clock.end;
  std::vector<AskedReaction> asked;
  std::set<std::string> named;
  const auto ask =
      [&](const std::string &name, const std::string &support, const scene::Probe &probe)
  {
    const double interval = scene::sample_interval(probe, end);
    asked.push_back({name, support, {scene::sample_times(probe, end), interval / 2, end}});
  };
  for (const scene::Probe &probe : scene.probes)
    if (const auto *reaction = std::get_if<scene::ReactionProbe>(&probe.kind))
    {
      named.insert(reaction->support);
      ask(probe.name, reaction->support, probe);
    }
  for (const scene::Support &support : scene.supports)
    if (named.count(support.name) == 0)
    {
      scene::Probe probe;
      probe.kind = scene::ReactionProbe{support.name};
      ask("reaction " + support.name, support.name, probe);
    }
  return asked;
}

std::vector<double> recorded_times(const scene::Scene &scene)
{
  std::vector<double> all;
  const auto add = [&](const std::vector<double> &times)
  { all.insert(all.end(), times.begin(), times.end()); };
  for (const scene::Probe &probe : scene.probes)
    if (!std::holds_alternative<scene::ReactionProbe>(probe.kind))
      add(scene::sample_times(probe, scene.clock.end));
  for (const AskedReaction &asked : asked_reactions(scene))
    add(ReactionWindow(asked.sampling).events());
  return apart_by(1e-9 * scene.clock.end, std::move(all));
}
