// A density scaled for a slow load: waves must still have time to bring the bodies to rest.
#include <gtest/gtest.h>

#include "inertia.h"
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
