// A density scaled for a slow load: waves must still have time to bring the bodies to rest.
#include <gtest/gtest.h>

#include "inertia.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  std::string said(const std::string &of_points, const std::string &of_body = "")
  {
    const scene::Scene scene =
        scene_of("title = \"t\"\n[domain]\nsize = [2.0, 2.0]\ncells = [8, 8]\n"
                 "[[body]]\nshape = \"rectangle\"\ncorner = [0.5, 0.0]\nsize = [1.0, 1.0]\n" +
                 of_body +
                 "[solid]\nyoung_modulus = 1e6\npoisson_ratio = 0.3\ndensity = 1000.0\n"
                 "[[support]]\non = \"bottom\"\ndisplacement = [\"free\", \"0\"]\n"
                 "[body_force]\nacceleration = [\"0\", \"-10*smooth(t, 100)\"]\n"
                 "[clock]\nend = 150.0\n[mpm]\n" +
                 of_points);
    return warning_on_scaling(build_world(scene, 1));
  }
} // namespace

// The wave speed is V/Ma: it crosses the metre 150 V/Ma times.
TEST(Scaling, IsDoubtedWhereWavesCrossTheBodyAFewTimesOnly)
{
  EXPECT_EQ(said(""), "");
  EXPECT_EQ(said("mach = 1e-3\nreference_speed = 3e-4\n"), "");
  EXPECT_NE(said("mach = 1e-3\nreference_speed = 2e-5\n").find("crosses the bodies 3 times"),
            std::string::npos);
  EXPECT_NE(
      said("mach = 1e-3\nreference_speed = 3e-4\n", "velocity = [1e-3, 0]\n").find("momentum"),
      std::string::npos);
  EXPECT_EQ(said("mach = 1e-3\nreference_speed = 3e-4\n", "velocity = [\"0.0\", \"-0\"]\n"), "")
      << "at rest, however it is written";
}

// A cantilever three times as long as high is bent by its end within a second. Waves cross it often
// enough with Mach 1e-3 too, but its own period is three seconds then.
TEST(Scaling, IsDoubtedWhereABodySwingsInsteadOfBending)
{
  const auto said_at_the_end = [](const std::string &mach)
  {
    const scene::Scene scene =
        scene_of("title = \"t\"\n[domain]\nsize = [4.0, 2.0]\ncells = [16, 8]\n"
                 "[[body]]\nshape = \"rectangle\"\ncorner = [0.5, 0.5]\nsize = [3.0, 1.0]\n"
                 "[solid]\nyoung_modulus = 1e6\npoisson_ratio = 0.3\ndensity = 1000.0\n"
                 "[[support]]\non = \"left\"\ndisplacement = [\"0\", \"0\"]\n"
                 "[[support]]\non = \"right\"\ndisplacement = [\"free\", \"0.01*smooth(t, 1)\"]\n"
                 "[clock]\nend = 1.2\n[mpm]\nmach = " +
                 mach + "\n");
    World world = build_world(scene, 1);
    while (world.time < 1.2)
      step(world, 0.05);
    EXPECT_EQ(warning_on_scaling(world), "") << mach;
    return warning_on_kinetic_energy(world);
  };
  EXPECT_EQ(said_at_the_end("1e-4"), "");
  EXPECT_NE(said_at_the_end("1e-3").find("not quasi-static"), std::string::npos);
}
