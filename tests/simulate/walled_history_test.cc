// What the history says of the melt holds between the walls, not behind or along them.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "melt_history.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  /// Up to the clock's end.
  World run(const scene::Scene &scene)
  {
    World world = build_world(scene, 1);
    while (!finished(world))
      step(world, coupling_step(world));
    return world;
  }

  std::map<std::string, double> history(const World &world)
  {
    const HistoryColumns row = melt_history(world);
    std::map<std::string, double> by_name;
    for (std::size_t k = 0; k < row.names.size(); ++k)
      by_name[row.names[k]] = row.values[k];
    return by_name;
  }
} // namespace

// A fifth swept away by a wall at x = s that carries its melt along: theta = 0.3 everywhere holds
// 0.3 (2 - s) then, has lost 0.3 s to the wall, and its mean stays. The motion 0.2 (2 - x)/(2 - s)
// squeezes cos(pi (x - s)/(2 - s)), which holds no heat.
TEST(WalledHeat, IsCountedBetweenTheWalls)
{
  const std::string head =
      "title = \"t\"\n[domain]\nsize = [2.0, 1.0]\ncells = [40, 20]\n"
      "[[wall]]\nside = \"left\"\nspeed = 0.2\ntravel = 0.5\nstart_time = 0.0\n"
      "[clock]\nend = 2.0\n[heat]\ndiffusivity = 0.01\nundercooling = 0.0\n";
  const auto at_the_end = [&](const std::string &rest)
  {
    const scene::Scene scene = scene_of(head + rest);
    const World world = run(scene);
    auto row = history(world);
    row["s"] = world.walls->walls[0].position;
    EXPECT_GT(row["s"], 0.399);
    row["swept"] = world.walls->swept_heat;
    return row;
  };
  auto even = at_the_end("initial = 0.3\n[imposed]\nvelocity = [0.2, 0.0]\n");
  EXPECT_NEAR(even["heat_content"], 0.3 * (2. - even["s"]), 1e-10);
  EXPECT_NEAR(even["swept"], 0.3 * even["s"], 1e-10);
  EXPECT_NEAR(even["theta_mean"], 0.3, 1e-10);
  auto wave = at_the_end("initial = \"0.3*cos(3.141592653589793*X/2)\"\n"
                         "[imposed]\nvelocity = [\"0.2*(2-x)/(2-0.2*t)\", 0.0]\n");
  EXPECT_NEAR(wave["heat_content"], 0., 2e-3);
  EXPECT_NEAR(wave["theta_mean"], 0., 2e-3);
}

// A wall presses on a marked block from above and squeezes it evenly, its upright sides at rest:
// the interface is what the two sides show. Along the wall the contour closes where phi is even.
TEST(WalledFront, HasTheWidthOfItsFreeSides)
{
  const scene::Scene scene =
      scene_of("title = \"t\"\n[domain]\nsize = [2.0, 1.0]\ncells = [40, 20]\n"
               "[[body]]\nshape = \"rectangle\"\ncorner = [0.6, 0.0]\nsize = [0.8, 1.0]\n"
               "[phase_field]\nwidth = 0.1\n"
               "[[wall]]\nside = \"top\"\nspeed = 0.2\ntravel = 0.5\nstart_time = 0.0\n"
               "[imposed]\nvelocity = [0.0, \"-0.2*y/(1-0.2*t)\"]\n"
               "[clock]\nend = 1.0\n");
  const World world = run(scene);
  EXPECT_NEAR(history(world)["interface_width"], 0.1, 0.005);
}
