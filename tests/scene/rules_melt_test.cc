// One broken scene per rule of melt, walls and motions.
#include "broken_scene.h"

using namespace scene_test;

namespace
{
  const std::string wall = "[solid]\nyoung_modulus = 1e4\npoisson_ratio = 0.3\ndensity = 1\n"
                           "[[wall]]\nside = \"top\"\n";

  const std::string marker = "title = \"t\"\n[domain]\nsize = [10, 10]\ncells = [20, 20]\n"
                             "[[body]]\nshape = \"disc\"\ncentre = [5, 5]\nradius = 2\n"
                             "[phase_field]\nwidth = 0.025\n"
                             "[imposed]\nvelocity = [1, 0]\n[clock]\nend = 1\n";

  const std::vector<Broken> melt{
      {"interface_far_below_a_cell", marker, "width", "0.05 cells of 0.5"},
      {"anisotropy_past_a_fifteenth", with(seed, "0.05", "0.07"), "anisotropy", "1/15"},
      {"anisotropy_of_a_fifteenth", with(seed, "0.05", "0.06666666666666667"), "anisotropy",
       "less than 1/15"},
      {"mesh_of_two_cells", with(with(seed, "[40.0, 40.0]", "[2.0, 2.0]"), "[100, 100]", "[2, 2]"),
       "cells", "at least 3 cells"},
      {"band_without_room",
       plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
                  "[extension]\nband = 2\n"),
       "band", "at least 3"},
      {"wall_on_a_fixed_side",
       plus(with(seed, "boundary = \"symmetry\"",
                 "boundary = {left = \"symmetry\", bottom = \"symmetry\", top = \"fixed\"}"),
            wall + "speed = 1\ntravel = 1\n"),
       "[[wall]]", "fixed side"},
      {"walls_that_meet", plus(seed, wall + "speed = 1\ntravel = 39\n"), "[[wall]]",
       "fewer than five cells"},
      {"kinetics_that_do_not_vanish", with(seed, "diffusivity = 3.0", "diffusivity = 4.0"),
       "[growth]", "relaxation_time = 0.748"},
      {"kinetics_that_disagree",
       with(seed, "anisotropy = 0.05", "anisotropy = 0.05\nkinetic_coefficient = 1.0"), "[growth]",
       "is asked"},
      {"noise_on_a_quarter", plus(seed, "[noise]\nstrength = 1e-4\n"), "[noise]", "symmetry"},
      {"mirrored_odd_cells",
       plus(with(with(with(with(seed, "boundary = \"symmetry\"\n", ""), "[100, 100]", "[101, 101]"),
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
      {"advections_at_no_interval",
       plus(seed, "[imposed]\nvelocity = [1, 0]\n[advection]\ninterval = 0\n"), "interval",
       "at least 1"},
      {"distance_older_than_its_map",
       plus(seed, "[solid]\nyoung_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
                  "[extension]\ninterval = 30\n"),
       "interval", "every 20 extensions"},
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
      {"body_velocity_without_solid", with(seed, "radius = 8.0", "radius = 8.0\nvelocity = [1, 0]"),
       "velocity", "without [solid]"},
      {"tilted_crystal_on_a_quarter", plus(seed, "[orientation]\nangle_degrees = 20\n"),
       "angle_degrees", "mirror image"},
      {"heat_that_nothing_carries", plus(bar, "[heat]\ndiffusivity = 1\nundercooling = 0.5\n"),
       "[heat]", "no [phase_field]"},
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
} // namespace

class BrokenMelt : public testing::TestWithParam<Broken>
{
};
TEST_P(BrokenMelt, IsRefusedWithFileLineAndReason)
{
  expect_refused(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Rules, BrokenMelt, testing::ValuesIn(melt), name_of);
