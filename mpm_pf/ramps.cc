#include "ramps.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "inertia.h"
#include "scene/body_sizes.h"
#include "scene/geometry.h"
#include "scene/quasi_static.h"

namespace
{
  constexpr double enough = 10.;          // transits
  constexpr double nearly = 0.9 * enough; // scenes are written with round numbers
  constexpr double bearable = 0.01;       // of the strength

  /// The stress rho c V of an impact at that speed over what the material bears.
  double impact_ratio(const World &world, const double speed)
  {
    const scene::Solid &solid = *world.scene->solid;
    const double strength = solid.yield_stress.value_or(0.01 * solid.young_modulus);
    const solid::DensityScaling scaling = solid::density_scaling(*world.solid);
    return scaling.density * scaling.wave_speed * speed / strength;
  }

  struct Load
  {
    std::string name, remedy;
    double speed, time, length; // to be reached; within that time; of the material before it
  };

  std::string sentence(const World &world, const Load &load)
  {
    const double transit = load.length / solid::density_scaling(*world.solid).wave_speed;
    const double stress = impact_ratio(world, load.speed), transits = load.time / transit;
    if (transits >= nearly || !(stress > bearable))
      return {};
    std::ostringstream text;
    text << std::setprecision(2) << load.name << " is brought to its speed in " << transits
         << " transits of an elastic wave; fewer than " << enough
         << " leave waves of up to rho c V, " << std::setprecision(3) << stress
         << (world.scene->solid->yield_stress ? " yield stresses" : " % of strain") << ": "
         << load.remedy << ' ' << enough * transit << " or more";
    if (world.scene->mpm && world.scene->mpm->mach)
      text << ", or a lower mpm.mach";
    return text.str();
  }

  void add(std::string &all, const std::string &sentence)
  {
    if (!sentence.empty())
      all += (all.empty() ? "" : "; ") + sentence;
  }

  /// How long it speeds up from the contact on; 0 for one that arrives at its full speed.
  double ramp_in_contact(const medium::Wall &wall)
  {
    if (wall.asked.contact_ramp.value_or(0.) > 0.)
      return *wall.asked.contact_ramp;
    const double ramp = wall.asked.ramp.value_or(0.);
    return std::max(0., wall.started.value_or(*wall.touched) + ramp - *wall.touched);
  }

  /// Speeds of a support, the largest among the corners of the bodies, at even times.
  std::vector<double> speeds_of(const scene::Support &support, const scene::Box &box,
                                const double interval, const int count)
  {
    std::vector<double> speeds(static_cast<std::size_t>(count), 0.);
    for (const auto &component : support.displacement)
      if (component)
      {
        const scene::Function u(*component);
        for (const scene::Point &X : {box.lower, box.upper})
          for (int k = 0; k < count; ++k)
          {
            const double change = u({X, X, (k + 1) * interval}) - u({X, X, k * interval});
            double &speed = speeds[static_cast<std::size_t>(k)];
            speed = std::max(speed, std::abs(change) / interval); // what is no number is none
          }
      }
    return speeds;
  }
} // namespace

void choose_wall_ramps(World &world)
{
  const double wave_speed = solid::density_scaling(*world.solid).wave_speed;
  for (medium::Wall &wall : world.walls->walls)
  {
    if (wall.asked.start_time)
      continue;
    const double chosen = enough * arm(world, wall) / wave_speed;
    wall.asked.ramp = wall.asked.ramp.value_or(chosen);
    wall.asked.contact_ramp = wall.asked.contact_ramp.value_or(chosen);
  }
}

std::string warning_on_wall_ramps(const World &world)
{
  std::string all;
  if (!world.solid || !world.walls)
    return all;
  for (const medium::Wall &wall : world.walls->walls)
    if (wall.touched && wall.asked.speed > 0.)
      add(all, sentence(world, {solid::wall_name(wall.side), "give a contact_ramp of",
                                wall.asked.speed, ramp_in_contact(wall), arm(world, wall)}));
  return all;
}

std::string warning_on_support_ramps(const World &world)
{
  const scene::Scene &scene = *world.scene;
  std::string all;
  if (!world.solid || scene.growth || !scene.mpm || !scene.mpm->mach)
    return all;
  const scene::Box box = scene::bounding_box(scene.bodies);
  std::vector<const scene::Support *> driven;
  for (const scene::Support &support : scene.supports)
    // Where all is covered, nothing is left free for a wave to run in.
    if (scene::is_driven(support) && !scene::covers(support, box))
      driven.push_back(&support);
  // Where both ends are driven, the middle is what a wave from either comes to.
  const double length = (box.upper - box.lower).maxCoeff() / (driven.size() > 1 ? 2. : 1.);
  const double window =
      std::min(scene.clock.end, enough * length / solid::density_scaling(*world.solid).wave_speed);
  constexpr int samples = 400;
  for (const scene::Support *support : driven)
  {
    const std::vector<double> speeds = speeds_of(*support, box, window / samples, samples);
    const double speed = *std::max_element(speeds.begin(), speeds.end());
    if (!(speed > 0.))
      continue;
    // smooth() is at 0.95 after 0.81 of its time; whatever still gains speed at the window's end
    // gets there after 0.95 of it.
    const auto first = std::find_if(speeds.begin(), speeds.end(),
                                    [&](const double v) { return v >= 0.95 * speed; });
    const double reached = (static_cast<double>(first - speeds.begin()) + 0.5) * window / samples;
    add(all, sentence(world, {"support \"" + support->name + '"',
                              "let its displacement set in with ramp(t, T) of T =", speed,
                              first == speeds.begin() ? 0. : reached / 0.81, length}));
  }
  return all;
}
