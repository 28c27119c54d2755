#include "plan.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

#include "costs.h"
#include "forecast.h"
#include "scene/presets.h"
#include "step_count.h"

namespace
{
  struct Module
  {
    std::string name;
    const scene::SourceLocation *place; // null: absent
  };

  std::vector<Module> modules(const scene::Scene &s)
  {
    const auto place = [](const auto &section) { return section ? &section->place : nullptr; };
    return {{"solid", place(s.solid)},
            {"supports", s.supports.empty() ? nullptr : &s.supports.front().place},
            {"tractions", s.tractions.empty() ? nullptr : &s.tractions.front().place},
            {"body force", place(s.body_force)},
            {"phase field", place(s.phase_field)},
            {"growth", place(s.growth)},
            {"heat", place(s.heat)},
            {"orientation", place(s.orientation)},
            {"noise", place(s.noise)},
            {"imposed motion", place(s.imposed)},
            {"walls", s.walls.empty() ? nullptr : &s.walls.front().place}};
  }
} // namespace

std::string banner(const scene::Scene &scene)
{
  std::ostringstream out;
  out << "mpm_pf: " << scene.title << " (" << scene.file << ")\n  on: ";
  std::string off;
  bool first = true;
  for (const auto &module : modules(scene))
    if (module.place)
    {
      out << (first ? "" : ", ") << module.name << " (line " << module.place->line << ")";
      first = false;
    }
    else
      off += (off.empty() ? "" : ", ") + module.name;
  out << "\n  off: " << off << '\n';
  out << scene::describe_preset(scene);
  if (scene.fe)
    out << "  [fe] is read by fe_reference only\n";
  return out.str();
}

std::string size(const World &world)
{
  const scene::Scene &scene = *world.scene;
  std::ostringstream out;
  out << std::setprecision(3) << "  size: " << scene.domain.cells[0] << " x "
      << scene.domain.cells[1] << " cells";
  if (world.solid && solid::points(*world.solid) > 0)
    out << ", " << solid::points(*world.solid) << " points";
  else if (world.solid)
    out << ", points once the crystal has them";
  const char *const word = world.walls ? ", up to " : ", about "; // walls end a run
  const auto steps = [&](const double step)
  { return std::max(1., std::ceil(scene.clock.end / step)); };
  if (world.growth)
    out << word << steps(growth_step(world)) << " steps of " << (world.phase ? "growth" : "heat");
  if (world.solid)
    out << word << count_solid_steps(world).substeps << " steps of the solid";
  if (!world.growth && !world.solid)
    out << word << steps(coupling_step(world)) << " steps";
  double bytes = 0.;
  for (const auto &[what, held] : memory(world))
    bytes += held;
  out << "; " << bytes / 1e6 << " MB in the modules now\n";
  return out.str();
}

std::string plan(const scene::Scene &scene, const int threads, const bool force)
{
  std::ostringstream out;
  out << banner(scene) << "  domain: " << scene.domain.cells[0] << " x " << scene.domain.cells[1]
      << " cells\n"
      << describe(make_forecast(scene, threads, force));
  return out.str();
}
