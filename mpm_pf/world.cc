#include "world.h"

#include <algorithm>
#include <limits>

World build_world(const scene::Scene &scene, const int threads)
{
  World world;
  world.scene = &scene;
  world.threads = threads;
  if (scene.solid)
    world.solid = solid::make_solid(scene, threads);
  return world;
}

std::map<std::string, double> memory(const World &world)
{
  std::map<std::string, double> bytes;
  if (world.solid)
    for (const auto &[part, size] : solid::memory(*world.solid))
      bytes["solid " + part] = size;
  return bytes;
}

double coupling_step(const World &world)
{
  double step = std::numeric_limits<double>::infinity();
  if (world.scene->clock.step)
    step = *world.scene->clock.step;
  // A solid on its own substeps as it likes; coming back every few hundred steps lets the run be
  // watched, interrupted and checkpointed.
  constexpr double steps_between_looks = 500.;
  if (world.solid)
    step = std::min(step, steps_between_looks * solid::stable_step(*world.solid));
  return step;
}

std::vector<record::Profile::Part> parts(const World &world)
{
  return world.solid ? solid::profile(*world.solid) : std::vector<record::Profile::Part>{};
}

std::map<std::string, double> numbers(const World &world)
{
  std::map<std::string, double> all{{"coupling_steps", static_cast<double>(world.steps)}};
  if (world.solid)
  {
    all = solid::numbers(*world.solid);
    all["steps"] = static_cast<double>(solid::steps(*world.solid));
    all["points"] = static_cast<double>(solid::points(*world.solid));
    all["cells"] = static_cast<double>(solid::cells(*world.solid));
  }
  return all;
}

std::map<std::string, double> predict(const World &world)
{
  std::map<std::string, double> counts;
  if (world.solid)
  {
    const double steps = world.scene->clock.end / solid::stable_step(*world.solid);
    const double points = static_cast<double>(solid::points(*world.solid));
    constexpr double seconds_per_point_step = 6e-8; // measured: benchmarks/kernels
    counts["points"] = points;
    counts["cells"] = static_cast<double>(solid::cells(*world.solid));
    counts["steps"] = steps;
    counts["cpu_s"] = steps * points * seconds_per_point_step;
  }
  return counts;
}

void save(const World &world, record::Checkpoint &checkpoint)
{
  if (world.solid)
    for (auto &[name, values] : solid::checkpoint(*world.solid))
      checkpoint.put("solid/" + name, values);
}

void restore(World &world, const record::Checkpoint &checkpoint)
{
  if (world.solid)
  {
    solid::Checkpoint state = solid::checkpoint(*world.solid);
    for (auto &[name, values] : state)
      values = checkpoint.get<double>("solid/" + name);
    solid::restore(*world.solid, state);
  }
}
