// A load that sets in within a few transits of an elastic wave is told, and only where waves tell.
#include "ramps.h"

#include <string>

#include "coupling.h"
#include "scene_of.h"
#include "simulate.h"

namespace
{
  using simulated::Folder;
  using simulated::scene_of;

  /// Stands between the bottom and a wall above; E = 100, nu = 0.3: c = 36.7 at a density of 0.1.
  std::string said_of_wall(const std::string &wall, const std::string &density = "0.1")
  {
    const Folder folder;
    const auto scene = scene_of(
        folder, "title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [16, 16]\n"
                "[[body]]\nshape = \"rectangle\"\ncorner = [4.0, 0.0]\nsize = [8.0, 16.0]\n"
                "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\ndensity = " +
                    density +
                    "\n[[support]]\non = \"bottom\"\ndisplacement = [\"free\", \"0\"]\n"
                    "[[wall]]\nside = \"top\"\ntravel = 4.0\nstart_time = 0.0\n" +
                    wall + "[clock]\nend = 10.0\n");
    World world = build_world(scene, 1);
    for (int k = 0; k < 20 && !world.walls->walls[0].touched; ++k)
      step(world, 0.02);
    EXPECT_TRUE(world.walls->walls[0].touched) << wall;
    return warning_on_wall_ramps(world);
  }

  /// A square of 2 with c = 100 at the Mach number 1e-3 of ends that move at 0.1.
  std::string said_of_supports(const std::string &motion, const std::string &mpm,
                               const std::string &where = "on = \"top\"")
  {
    const Folder folder;
    const auto scene =
        scene_of(folder, "title = \"t\"\n[domain]\nsize = [4.0, 4.0]\ncells = [8, 8]\n"
                         "[[body]]\nshape = \"rectangle\"\ncorner = [1.0, 1.0]\nsize = [2.0, 2.0]\n"
                         "[solid]\nyoung_modulus = 1e3\npoisson_ratio = 0.3\ndensity = 1e-6\n"
                         "[[support]]\nname = \"driven\"\n" +
                             where + "\ndisplacement = [\"0\", \"" + motion +
                             "\"]\n[clock]\nend = 4.0\n[mpm]\n" + mpm);
    return warning_on_support_ramps(build_world(scene, 1));
  }

  bool says(const std::string &message, const std::string &words)
  {
    return message.find(words) != std::string::npos;
  }

  const std::string scaled = "mach = 1e-3\n";
} // namespace

// The arm is half of the 16 between the wall and the bottom: ten transits take 80/36.7 = 2.2.
TEST(WallRamp, OfFewTransitsIsTold)
{
  const std::string blow = said_of_wall("speed = 0.1\n");
  EXPECT_TRUE(says(blow, "wall top is brought to its speed in 0 transits")) << blow;
  EXPECT_TRUE(says(blow, "0.367 % of strain")) << blow; // rho c V = 0.1 * 36.7 * 0.1
  EXPECT_TRUE(says(blow, "give a contact_ramp of 2.18 or more")) << blow;
  EXPECT_TRUE(says(said_of_wall("speed = 0.1\ncontact_ramp = 1.1\n"), "in 5 transits"));
  EXPECT_EQ(said_of_wall("speed = 0.1\ncontact_ramp = 2.2\n"), "");
}

// A wall that starts in contact has no other ramp; one that is slow enough needs none.
TEST(WallRamp, IsNotAskedForWhereItDoesNotMatter)
{
  EXPECT_EQ(said_of_wall("speed = 0.1\nramp = 3.0\n"), "");
  EXPECT_EQ(said_of_wall("speed = 0.002\n"), ""); // rho c V: 0.007 % of strain
}

// 100 W0 of crystal below the mirror or up to the middle, c = reference speed/Mach = 0.1/1e-3.
TEST(WallRamp, OfAWallThatWaitsForAFrontIsTenTransits)
{
  const auto wall_of = [](const std::string &wall, const std::string &bottom)
  {
    const Folder folder;
    const auto scene = scene_of(
        folder, "title = \"t\"\n[units]\nsystem = \"W0-tau0-sigmaY\"\n[domain]\nsize = [40.0, "
                "100.0]\ncells = [40, 100]\nboundary = { left = \"no_flux\", right = \"no_flux\", "
                "bottom = \"" +
                    bottom +
                    "\", top = \"no_flux\" }\n[[body]]\nshape = \"disc\"\ncentre = [20.0, "
                    "50.0]\nradius = 8.0\n[phase_field]\nwidth = 1.0\n[growth]\n"
                    "capillary_length = 0.185\n[heat]\ndiffusivity = 3.0\nundercooling = 0.55\n"
                    "[solid]\nyoung_modulus = 1e4\npoisson_ratio = 0.3\ndensity = 1.0\n[mpm]\nmach "
                    "= 1e-3\n[[wall]]\nside = \"top\"\nspeed = 0.1\ntravel = 4.0\n" +
                    wall + "[clock]\nend = 1.0\n");
    return build_world(scene, 1).walls->walls[0].asked;
  };
  const auto mirrored = wall_of("", "symmetry"), whole = wall_of("", "no_flux");
  EXPECT_NEAR(*mirrored.ramp, 10., 1e-9);
  EXPECT_NEAR(*mirrored.contact_ramp, 10., 1e-9);
  EXPECT_NEAR(*whole.ramp, 5., 1e-9);
  EXPECT_NEAR(*whole.contact_ramp, 5., 1e-9);
  const auto told = wall_of("ramp = 3.0\ncontact_ramp = 0.0\n", "no_flux");
  EXPECT_EQ(*told.ramp, 3.);
  EXPECT_EQ(*told.contact_ramp, 0.);
  const auto timed = wall_of("start_time = 0.5\n", "no_flux");
  EXPECT_FALSE(timed.ramp || timed.contact_ramp);
}

// A wave takes 0.02 across the body.
TEST(SupportRamp, OfFewTransitsIsTold)
{
  const std::string at_once = said_of_supports("0.1*t", scaled);
  EXPECT_TRUE(says(at_once, "support \"driven\" is brought to its speed in 0 transits")) << at_once;
  EXPECT_TRUE(says(at_once, "ramp(t, T) of T = 0.2 or more, or a lower mpm.mach")) << at_once;
  const std::string short_ramp = said_of_supports("0.1*ramp(t, 0.1)", scaled);
  EXPECT_TRUE(says(short_ramp, "in 5 transits")) << short_ramp;
  EXPECT_EQ(said_of_supports("0.1*ramp(t, 0.21)", scaled), "");
  EXPECT_EQ(said_of_supports("0.1*ramp(t, 2)", scaled), "");
}

// From both ends a wave has half as far to go.
TEST(SupportRamp, NeedsHalfTheTimeWhereBothEndsAreDriven)
{
  const std::string both = "on = \"bottom\"\ndisplacement = [\"0\", \"-0.1*ramp(t, 0.1)\"]\n"
                           "[[support]]\nname = \"other\"\non = \"top\"";
  EXPECT_EQ(said_of_supports("0.1*ramp(t, 0.1)", scaled, both), "");
  const std::string one = said_of_supports("0.1*ramp(t, 0.08)", scaled, both);
  EXPECT_TRUE(says(one, "support \"other\" is brought to its speed in 8 transits")) << one;
  EXPECT_FALSE(says(one, "driven")) << one;
}

TEST(SupportRamp, IsNotAskedForWhereItDoesNotMatter)
{
  EXPECT_EQ(said_of_supports("0.1*t", ""), "") << "a step may be the problem itself";
  EXPECT_EQ(said_of_supports("0", scaled + "reference_speed = 0.1\n"), "") << "at rest";
  EXPECT_EQ(said_of_supports("0.0125*t*t", scaled), "") << "slow while waves would tell";
  EXPECT_EQ(said_of_supports("1e-5*t", scaled + "reference_speed = 0.1\n"), "")
      << "too slow to tell";
  EXPECT_EQ(said_of_supports("0.1*t", scaled, "region = {lower = [0.9, 0.9], upper = [3.1, 3.1]}"),
            "")
      << "nothing is left for a wave to run in";
  // 1 + 1/3 + 5/3, added up in decimals, misses 3 by 1e-10.
  EXPECT_EQ(said_of_supports("0.1*t", scaled,
                             "region = {lower = [1.0, 1.0], upper = [3.0, 2.9999999999]}"),
            "")
      << "rounding leaves nothing free either";
  EXPECT_NE(said_of_supports("0.1*t", scaled, "region = {lower = [1.0, 1.0], upper = [3.0, 2.9]}"),
            "");
}
