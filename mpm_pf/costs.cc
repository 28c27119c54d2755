#include "costs.h"

namespace
{
  double bytes(const AdvectedField &field)
  {
    return static_cast<double>(field.value.bytes() + field.gradients.bytes());
  }
} // namespace

std::map<std::string, double> memory(const World &world)
{
  std::map<std::string, double> held;
  if (world.phase)
    held["phase field"] = bytes(*world.phase);
  if (world.heat)
    held["heat"] = bytes(*world.heat);
  if (world.orientation)
    held["orientation"] = static_cast<double>(world.orientation->bytes());
  if (world.growth)
    held["growth"] = static_cast<double>(world.growth->bytes());
  if (world.noise)
    held["noise"] = static_cast<double>(world.noise->bytes());
  if (world.walls)
    held["walls"] = static_cast<double>(medium::bytes(*world.walls));
  if (world.imposed)
    held["imposed motion"] = sizeof(*world.imposed);
  if (world.velocity)
    held["velocity"] = static_cast<double>(world.velocity->x.bytes() + world.velocity->y.bytes());
  if (world.advection)
    held["advection"] = static_cast<double>(world.advection->bytes());
  if (world.uncarried)
    held["mean velocity"] = static_cast<double>(world.uncarried->bytes());
  if (world.extension)
    held["extension"] = static_cast<double>(medium::bytes(*world.extension));
  if (world.solid)
    for (const auto &[part, size] : solid::memory(*world.solid))
      held["solid " + part] = size;
  return held;
}

std::vector<record::Profile::Part> parts(const World &world)
{
  auto all = world.solid ? solid::profile(*world.solid) : std::vector<record::Profile::Part>{};
  for (const auto &[module, part] : world.spent)
    all.push_back(part);
  if (world.extension)
    all.push_back(world.extension->measuring);
  return all;
}

std::map<std::string, double> numbers(const World &world)
{
  std::map<std::string, double> all;
  if (world.solid)
  {
    const solid::DensityScaling scaling = solid::density_scaling(*world.solid);
    all = {{"density", scaling.density},
           {"density_scale", scaling.scale},
           {"wave_speed", scaling.wave_speed},
           {"reference_speed", scaling.reference_speed},
           {"mach", scaling.mach()}};
    all["steps"] = static_cast<double>(solid::steps(*world.solid));
    all["points"] = static_cast<double>(solid::points(*world.solid));
    all["cells"] = static_cast<double>(solid::cells(*world.solid));
  }
  if (world.growth)
  {
    all["growth_steps"] = static_cast<double>(world.growth->steps_taken());
    all["growth_step"] = growth_step(world);
    all["nodes"] = static_cast<double>(world.mesh->node_count());
  }
  if (world.noise)
    all["noise_calls"] = static_cast<double>(world.noise->calls());
  all["coupling_steps"] = static_cast<double>(world.steps);
  return all;
}
