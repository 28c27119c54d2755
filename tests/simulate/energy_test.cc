// Energy that the transfers between points and grid eat is told.
#include <gtest/gtest.h>

#include "inertia.h"
#include "written_scene.h"

namespace
{
  World world_of(const std::string &text)
  {
    static std::vector<scene::Scene> scenes; // a world refers to its own
    scenes.reserve(8);
    scenes.push_back(scene_of(text));
    return build_world(scenes.back(), 1);
  }
} // namespace

// A free elastic beam of four cells' height that spins and swings: after a turn a quarter is gone.
TEST(Energy, ThatIsLostIsTold)
{
  const World world =
      world_of("title = \"t\"\n[domain]\nsize = [6.0, 6.0]\ncells = [48, 48]\n"
               "[[body]]\nshape = \"rectangle\"\ncorner = [1.0, 2.75]\nsize = [4.0, 0.5]\n"
               "velocity = [\"-(Y-3)\", \"(X-3)+2*cos(1.5708*(X-3))\"]\n"
               "[solid]\nyoung_modulus = 1000.0\npoisson_ratio = 0.3\ndensity = 1.0\n"
               "[clock]\nend = 12.0\n");
  solid::advance(*world.solid, 0.5);
  EXPECT_EQ(warning_on_energy(world), "");
  solid::advance(*world.solid, 11.5);
  EXPECT_NE(warning_on_energy(world).find("of the energy that the solid was given is lost"),
            std::string::npos)
      << solid::lost_energy(*world.solid).transfer;
  EXPECT_LT(std::abs(solid::lost_energy(*world.solid).unaccounted), 0.005);
  EXPECT_NE(warning_on_energy(world).find("dissipation of the transfers"), std::string::npos);
}

// Loaded and unloaded: the work comes back, and what is missing is compared with all of it.
TEST(Energy, ThatCameBackIsNotMissed)
{
  const World world = world_of(
      "title = \"t\"\n[domain]\nsize = [2.0, 2.0]\ncells = [16, 16]\n"
      "[[body]]\nshape = \"rectangle\"\ncorner = [0.5, 0.5]\nsize = [1.0, 1.0]\n"
      "[solid]\nyoung_modulus = 1000.0\npoisson_ratio = 0.3\ndensity = 1.0\n"
      "[[support]]\non = \"bottom\"\ndisplacement = [\"0\", \"0\"]\n"
      "[[support]]\non = \"top\"\ndisplacement = [\"0.1*(smooth(t, 1) - smooth(t - 1, 1))\", "
      "\"0\"]\n[clock]\nend = 2.0\n");
  solid::advance(*world.solid, 2.);
  EXPECT_EQ(warning_on_energy(world), "") << solid::lost_energy(*world.solid).transfer;
}
