// One broken scene per rule: the complaint must name file and line, and say why. Each scene breaks
// one rule only, so exactly one complaint may come.
#include "scene_file.h"

#include "scene/rules.h"

using namespace scene_test;

namespace
{
  struct Broken
  {
    std::string name;
    std::string text;   // of the scene
    std::string marked; // first words of the line that must be named
    std::string said;   // part of the complaint
  };

  void PrintTo(const Broken &broken, std::ostream *out)
  {
    *out << broken.name;
  }

  std::string plus(const std::string &text, const std::string &more)
  {
    return text + more;
  }

  const std::string still = with(with(bar, R"([[probe]]
name = "force"
reaction = "top"
)",
                                      ""),
                                 "mach = 2e-3\n", "");

  const std::vector<Broken> mechanics{
      {"negative_density", with(bar, "density = 7800", "density = -1"), "density", "read -1"},
      {"zero_modulus", with(bar, "2e11", "0.0"), "young_modulus", "greater than 0"},
      {"poisson_half", with(bar, "0.3", "0.5"), "poisson_ratio", "less than 0.5"},
      {"viscosity_alone", with(bar, "yield_stress = 4e8", "viscosity = 1e5"), "viscosity",
       "yield stress"},
      {"oblong_cells", with(bar, "[50, 24]", "[50, 12]"), "cells", "not square"},
      {"body_outside", with(bar, "corner = [2.0, 0.2]", "corner = [4.5, 0.2]"), "[[body]]",
       "right side by 0.5"},
      {"body_far_outside",
       plus(bar, "[[body]]\nname = \"far\"\nshape = \"disc\"\ncentre = [9, 1]\nradius = 1"),
       "[[body]]\nname", "outside the domain"},
      {"support_off_material",
       with(bar, "on = \"top\"", "name = \"top\"\nsegment = [[0, 1], [1, 1]]"), "segment",
       "no part of the outline"},
      {"region_off_material",
       with(bar, "on = \"top\"", "name = \"top\"\nregion = {lower = [0, 0], upper = [1.9, 2]}"),
       "region", "no material"},
      {"edge_that_is_a_point",
       with(with(bar, "shape = \"rectangle\"\ncorner = [2.0, 0.2]\nsize = [1.0, 2.0]",
                 "shape = \"polygon\"\nvertices = [[2, 0.2], [3, 0.2], [2.5, 2]]"),
            "on = \"top\"", "on = \"top\""),
       "on = \"top\"", "in a point only"},
      {"outline_that_crosses_itself",
       with(bar, "shape = \"rectangle\"\ncorner = [2.0, 0.2]\nsize = [1.0, 2.0]",
            "shape = \"polygon\"\nvertices = [[2, 0.2], [3, 0.2], [2.1, 2], [3, 2.2]]"),
       "vertices", "crosses"},
      {"outline_with_a_spike",
       with(bar, "shape = \"rectangle\"\ncorner = [2.0, 0.2]\nsize = [1.0, 2.0]",
            "shape = \"polygon\"\nvertices = [[2, 0.2], [3, 0.2], [3, 2.2], [3, 1], [2, 2.2]]"),
       "vertices", "crosses"},
      {"support_of_nothing", with(bar, "[\"0.4*t\", 0]", "[\"free\", \"free\"]"), "displacement",
       "holds nothing"},
      {"support_that_jumps", with(bar, "\"0.4*t\"", "\"0.4\""), "displacement", "start"},
      {"competing_supports",
       plus(bar, "[[support]]\nname = \"lid\"\non = \"top\"\ndisplacement = [0, \"free\"]\n"),
       "[[support]]\nname", "same component"},
      {"supports_that_part_an_edge",
       plus(bar, "[[support]]\nname = \"half\"\nsegment = [[2.5, 2.2], [3, 2.2]]\n"
                 "displacement = [\"0.1*t\", \"free\"]\n"),
       "[[support]]\nname", "same component"},
      {"displacement_that_is_no_number", with(bar, "\"0.4*t\"", "\"0.4*t*sqrt(0.5 - t)\""),
       "displacement", "no finite number at t = 0.53"},
      {"ramp_over_a_negative_time", with(bar, "\"0.4*t\"", "\"0.4*ramp(t, -1)\""), "displacement",
       "no finite number"},
      {"velocity_that_is_no_number",
       with(bar, "shape = ", "velocity = [\"sqrt(X - 2.5)\", 0]\nshape = "), "velocity",
       "no finite number at (2.0"},
      {"stress_that_is_no_number",
       with(bar, "shape = ", "initial_stress = [0, 0, 0, \"log(1 - Y)\"]\nshape = "),
       "initial_stress", "no finite number at (2.0"},
      {"weight_that_is_no_number",
       plus(bar, "[body_force]\nacceleration = [0, \"log(0.5 - t)\"]\n"), "acceleration",
       "no finite number at t = 0.5"},
      {"pressure_that_is_no_number",
       plus(bar, "[[traction]]\non = \"left\"\npressure = \"sqrt(Y - 1)\"\n"), "pressure",
       "no finite number at (2, "},
      {"bodies_at_odds",
       plus(bar, "[[body]]\nname = \"core\"\nshape = \"disc\"\ncentre = [2.5, 1.2]\nradius = "
                 "0.3\nvelocity = [1, 0]\n"),
       "[[body]]\nname", "overlap"},
      {"region_probe_beside_the_body",
       plus(bar, "[[probe]]\nname = \"r\"\nregion = {lower = [0, 0], upper = [1, 1]}\n"),
       "region = ", "no material starts"},
      {"traction_on_region",
       plus(bar,
            "[[traction]]\nregion = {lower = [2.2, 1], upper = [2.8, 2]}\ntraction = [1, 0]\n"),
       "region", "force per length"},
      {"traction_and_pressure",
       plus(bar, "[[traction]]\non = \"left\"\ntraction = [1, 0]\npressure = 2\n"), "pressure",
       "exclude each other"},
      {"traction_of_nothing", plus(bar, "[[traction]]\non = \"left\"\n"), "[[traction]]",
       "nothing says which"},
      {"flip_fraction_unused", plus(bar, "flip_fraction = 0.9\n"), "flip_fraction", "tpic"},
      {"stress_first_affine", plus(bar, "stress_update = \"first\"\n"), "stress_update", "tpic"},
      {"floor_unused",
       plus(bar, "transfer = \"flip\"\nstress_update = \"first\"\nnode_mass_floor = 0.1\n"),
       "node_mass_floor", "first"},
      {"relaxation_unused", plus(bar, "anti_locking = false\npressure_relaxation = 0.5\n"),
       "pressure_relaxation", "anti-locking"},
      {"speed_without_mach", with(bar, "mach = 2e-3", "reference_speed = 1.0"), "reference_speed",
       "without mach"},
      {"half_of_fe_cells", plus(bar, "[fe]\ncells = [0, 8]\n"), "cells = [0", "0"},
      {"step_of_nothing", plus(with(bar, "end = 1.0", "end = 1.0\nstep = 0.1"), ""), "step = 0",
       "nothing is coupled"},
      {"probe_outside", with(bar, "[3.5, 1.2]", "[5.5, 1.2]"), "line = ", "outside the domain"},
      {"point_off_material", plus(bar, "[[probe]]\nname = \"p\"\nat = [0.5, 0.5]\n"),
       "at = ", "no material starts"},
      {"region_probe_outside",
       plus(bar, "[[probe]]\nname = \"r\"\nregion = {lower = [6, 0], upper = [7, 1]}\n"),
       "region = ", "outside the domain"},
      {"unknown_quantity", with(bar, "\"plastic_strain\"]", "\"plastic_strian\"]"),
       "of = ", "did you mean \"plastic_strain\"?"},
      {"quantity_of_absent_module", with(bar, "\"plastic_strain\"]", "\"theta\"]"),
       "of = ", "needs [heat]"},
      {"reaction_of_no_support", with(bar, "reaction = \"top\"", "reaction = \"tpo\""), "reaction",
       "did you mean \"top\"?"},
      {"duplicate_names", with(bar, "name = \"force\"", "name = \"line\""),
       "name = \"line\"\nreaction", "taken by line 20"},
      {"slash_in_a_name", with(bar, "name = \"force\"", "name = \"a/b\""), "name = \"a/b\"",
       "slash"},
      {"times_past_the_end", with(bar, "reaction = \"top\"", "reaction = \"top\"\ntimes = [2]"),
       "times", "past the end"},
      {"times_unsorted", with(bar, "reaction = \"top\"", "reaction = \"top\"\ntimes = [1, 0.5]"),
       "times", "increase"},
      {"every_past_the_end", with(bar, "reaction = \"top\"", "reaction = \"top\"\nevery = 2"),
       "every", "longer than the run"},
      {"body_on_a_periodic_side",
       with(with(bar, "cells = [50, 24]",
                 "cells = [50, 24]\nboundary = {left = \"no_flux\", right "
                 "= \"no_flux\", bottom = \"periodic\", top = \"periodic\"}"),
            "corner = [2.0, 0.2]", "corner = [2.0, 0.0]"),
       "[[body]]", "no material"},
      {"every_without_end", with(bar, "reaction = \"top\"", "reaction = \"top\"\nevery = 1e-9"),
       "every", "records"},
      {"compressions_without_wall",
       with(bar, "reaction = \"top\"", "reaction = \"top\"\ncompressions = [0.1]"), "compressions",
       "without a wall"},
      {"times_and_every",
       with(bar, "reaction = \"top\"", "reaction = \"top\"\nevery = 0.1\ntimes = [0.5]"), "every",
       "exclude each other"},
      {"timed_velocity", with(bar, "shape = ", "velocity = [\"t\", 0]\nshape = "), "velocity",
       "depends on t"},
      {"tip_without_melt",
       plus(bar, "[[probe]]\nname = \"tip\"\ntip = {origin = [1, 1], direction = [1, 0]}\n"),
       "tip = ", "without [phase_field]"},
      {"contour_without_melt", plus(bar, "[[probe]]\nname = \"c\"\noutline = \"phase\"\n"),
       "outline", "needs [phase_field]"},
      {"noise_without_heat", plus(bar, "[noise]\nstrength = 1e-4\n"), "[noise]",
       "no use without [heat]"},
      {"wall_by_distance", plus(bar, "[[wall]]\nside = \"left\"\nspeed = 1\ntravel = 0.1\n"),
       "[[wall]]", "no phase field"},
      {"half_a_period",
       with(bar, "cells = [50, 24]", "cells = [50, 24]\nboundary = {left = \"periodic\"}"),
       "boundary", "periodic side faces"},
      {"no_solid_no_phase", "[domain]\nsize = [1, 1]\ncells = [4, 4]\n[clock]\nend = 1\n", "",
       "nothing happens"}};

  std::vector<Broken> melt()
  {
    const std::string wall = "[solid]\nyoung_modulus = 1e4\npoisson_ratio = 0.3\ndensity = 1\n"
                             "[[wall]]\nside = \"top\"\n";
    return {{"anisotropy_past_a_fifteenth", with(seed, "0.05", "0.07"), "anisotropy", "1/15"},
            {"kinetics_that_do_not_vanish", with(seed, "diffusivity = 3.0", "diffusivity = 4.0"),
             "[growth]", "relaxation_time = 0.748"},
            {"kinetics_that_disagree",
             with(seed, "anisotropy = 0.05", "anisotropy = 0.05\nkinetic_coefficient = 1.0"),
             "[growth]", "is asked"},
            {"noise_on_a_quarter", plus(seed, "[noise]\nstrength = 1e-4\n"), "[noise]", "symmetry"},
            {"mirrored_odd_cells",
             plus(with(with(with(with(seed, "boundary = \"symmetry\"\n", ""), "[100, 100]",
                                 "[101, 101]"),
                            "[40.0, 40.0]", "[40.4, 40.4]"),
                       "centre = [0.0, 0.0]", "centre = [20.2, 20.2]"),
                  "[noise]\nstrength = 1e-4\nmirrored = true\n"),
             "mirrored", "odd number"},
            {"imposed_and_solid",
             plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
                        "[imposed]\nvelocity = [0, 0]\n"),
             "[imposed]", "instead of a solid"},
            {"advection_of_rest", plus(seed, "[advection]\nstep_fraction = 0.1\n"), "[advection]",
             "nothing is carried"},
            {"extension_without_solid", plus(seed, "[extension]\nband = 3\n"), "[extension]",
             "no use without [solid]"},
            {"undercooling_without_limit", with(seed, "undercooling = 0.55", "undercooling = 1.2"),
             "undercooling", "nothing limits"},
            {"timed_temperature",
             with(seed, "undercooling = 0.55", "undercooling = 0.55\ninitial = \"t\""), "initial",
             "depends on t"},
            {"temperature_that_is_no_number",
             with(seed, "undercooling = 0.55", "undercooling = 0.55\ninitial = \"-0.55/(X + Y)\""),
             "initial", "no finite number at (0, 0)"},
            {"motion_that_is_no_number", plus(seed, "[imposed]\nvelocity = [0, \"sqrt(x - 1)\"]\n"),
             "velocity", "no finite number at (0, 0)"},
            {"wall_without_travel", plus(seed, wall + "speed = 1\n"), "[[wall]]", "no travel"},
            {"velocity_between_walls",
             plus(with(seed, "[[body]]\n", "[[body]]\nvelocity = [1, 0]\n"),
                  wall + "speed = 1\ntravel = 1\n"),
             "velocity", "grows between walls"},
            {"wall_across_the_domain", plus(seed, wall + "speed = 1\ntravel = 50\n"), "[[wall]]",
             "across the whole domain"},
            {"two_walls_on_a_side", plus(seed, wall + "[[wall]]\nside = \"top\"\n"),
             "[[wall]]\nside = \"top\"\n[[wall]]", "second wall"},
            {"stretched_quantity",
             plus(seed, "[[probe]]\nname = \"p\"\nat = [1, 1]\nof = [\"von_mises\"]\n"),
             "of = ", "needs [solid]"},
            {"region_without_solid", plus(seed, "[[probe]]\nname = \"r\"\nregion = \"all\"\n"),
             "region = ", "without [solid]"},
            {"mean_of_phi",
             plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
                        "[[probe]]\nname = \"r\"\nregion = \"all\"\nof = [\"phi\"]\n"),
             "of = ", "regions are of the solid"},
            {"body_velocity_without_solid",
             with(seed, "radius = 8.0", "radius = 8.0\nvelocity = [1, 0]"), "velocity",
             "without [solid]"},
            {"tilted_crystal_on_a_quarter", plus(seed, "[orientation]\nangle_degrees = 20\n"),
             "angle_degrees", "mirror image"},
            {"heat_that_nothing_carries",
             plus(bar, "[heat]\ndiffusivity = 1\nundercooling = 0.5\n"), "[heat]",
             "no [phase_field]"},
            {"support_of_a_growing_crystal",
             plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n[[support]]\n"
                        "region = {lower = [1, 1], upper = [3, 3]}\ndisplacement = [0, 0]\n"),
             "[[support]]", "beside [growth]"},
            {"strain_of_a_growing_crystal",
             plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
                        "[[probe]]\nname = \"p\"\nat = [1, 1]\nof = [\"log_strain_xx\"]\n"),
             "of = ", "no place in the first configuration"},
            {"step_twice",
             with(seed, "anisotropy = 0.05", "anisotropy = 0.05\nstep = 0.01\nstep_fraction = 0.5"),
             "step", "exclude each other"}};
  }
} // namespace

class BrokenScene : public testing::TestWithParam<Broken>
{
};

TEST_P(BrokenScene, IsRefusedWithFileLineAndReason)
{
  const Broken &broken = GetParam();
  const Folder folder;
  const std::string path = folder.write("broken.toml", broken.text);
  const std::string said = complaints(path);
  EXPECT_EQ(count(said, "[error]"), 1) << said;
  EXPECT_NE(said.find(broken.said), std::string::npos) << said;
  int line = broken.marked.empty() ? 1 : line_of(broken.text, broken.marked);
  // Of two keys that exclude each other, and of doubled sections, the second is marked.
  if (broken.name == "two_walls_on_a_side")
    line += 2;
  else if (broken.name == "step_twice")
    line += 1;
  EXPECT_NE(said.find(path + ":" + std::to_string(line) + ": "), std::string::npos)
      << "line " << line << " expected\n"
      << said;
}

const auto name_of = [](const testing::TestParamInfo<Broken> &info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Mechanics, BrokenScene, testing::ValuesIn(mechanics), name_of);
INSTANTIATE_TEST_SUITE_P(Melt, BrokenScene, testing::ValuesIn(melt()), name_of);

TEST(Rules, AcceptTheScenesThatTheyAreTriedOn)
{
  const Folder folder;
  EXPECT_EQ(complaints(folder.write("bar.toml", bar)), "");
  EXPECT_EQ(complaints(folder.write("seed.toml", seed)), "");
}

TEST(Rules, AcceptKineticsThatAgreeToOnePercent)
{
  const Folder folder;
  // lambda = 0.8839/0.185: tau0 = 0.6267 lambda/D asks D = 2.994; 0.9 % above that passes, 1.2 %
  // does not.
  EXPECT_EQ(
      complaints(folder.write("in.toml", with(seed, "diffusivity = 3.0", "diffusivity = 3.020"))),
      "");
  EXPECT_NE(
      complaints(folder.write("out.toml", with(seed, "diffusivity = 3.0", "diffusivity = 3.032"))),
      "");
  // With the kinetic coefficient given, D = 4: beta = 0.8839 (0.185/0.8839 - 0.6267/4) = 0.046515.
  EXPECT_EQ(complaints(folder.write("kinetic.toml",
                                    with(with(seed, "diffusivity = 3.0", "diffusivity = 4.0"),
                                         "[growth]", "[growth]\nkinetic_coefficient = 0.046515"))),
            "");
}

TEST(Rules, MachWithoutAnythingThatMovesIsRefused)
{
  const Folder folder;
  std::string text = still;
  for (int i = 0; i < 2; ++i)
  {
    const std::size_t from = text.find("[[support]]");
    text.erase(from, text.find("[[", from + 2) - from);
  }
  EXPECT_EQ(complaints(folder.write("still.toml", text)), "");
  EXPECT_NE(
      complaints(folder.write("mach.toml", text + "mach = 1e-3\n")).find("Mach number of what"),
      std::string::npos);
}
