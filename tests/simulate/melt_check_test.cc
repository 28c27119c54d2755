// No run ends on a melt that is no state any more.
#include "melt_check.h"

#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "scene_of.h"

namespace
{
  const std::string seed = "[domain]\nsize = [16, 16]\ncells = [20, 20]\n[phase_field]\nwidth = 1\n"
                           "[[body]]\nshape = \"disc\"\ncentre = [8, 8]\nradius = 5\n"
                           "[growth]\n[heat]\ndiffusivity = 3\nundercooling = 0.55\n"
                           "[clock]\nend = 1\n";
} // namespace

TEST(MeltCheck, SeesWhatIsOutOfBoundsOrNotFinite)
{
  const simulated::Folder folder;
  const scene::Scene scene = simulated::scene_of(folder, seed);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  World world = build_world(scene, 1);
  const auto trouble = [&] { return simulated::trouble_of([&] { check_melt(world); }); };
  EXPECT_EQ(trouble(), "");
  for (const double bad : {-2.5, nan, std::numeric_limits<double>::infinity()})
  {
    const double good = std::exchange(world.phase->value(10, 5), bad);
    EXPECT_NE(trouble().find("at (8, 4) has left its bounds"), std::string::npos) << trouble();
    world.phase->value(10, 5) = good;
  }
  world.heat->value(20, 20) = nan;
  EXPECT_NE(trouble().find("theta = nan at (16, 16)"), std::string::npos) << trouble();
}
