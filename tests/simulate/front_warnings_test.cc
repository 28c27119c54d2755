// A seed that is gone by the end of its run is told of.
#include <gtest/gtest.h>

#include "front_warnings.h"
#include "melt_history.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  const std::string seed = "title = \"t\"\n[domain]\nsize = [20, 20]\ncells = [25, 25]\n"
                           "boundary = \"symmetry\"\n"
                           "[[body]]\nshape = \"disc\"\ncentre = [0, 0]\nradius = 3\n"
                           "[phase_field]\nwidth = 1\n[growth]\n"
                           "[heat]\ndiffusivity = 3\nundercooling = 0.55\n";
} // namespace

TEST(MeltedCrystal, IsSaidWhereNothingIsLeftOfIt)
{
  const scene::Scene hot = scene_of(seed + "initial = \"0.5\"\n[clock]\nend = 100\n");
  World world = build_world(hot, 1);
  EXPECT_EQ(warning_on_melted_crystals(world), "") << "it is still there";
  for (int k = 0; k < 1000 && !phase_contour(world).empty(); ++k)
    step(world, growth_step(world));
  const std::string said = warning_on_melted_crystals(world);
  EXPECT_NE(said.find("has melted away"), std::string::npos) << said;
  EXPECT_NE(said.find("a colder heat.initial"), std::string::npos) << said;
}

TEST(MeltedCrystal, IsToldOfTheRadiusThatMustMelt)
{
  const scene::Scene cold = scene_of(seed + "[clock]\nend = 100\n");
  World world = build_world(cold, 1);
  for (int j = 0; j < world.mesh->nodes[1]; ++j)
    for (int i = 0; i < world.mesh->nodes[0]; ++i)
      world.phase->value(i, j) = -1.;
  const std::string said = warning_on_melted_crystals(world);
  EXPECT_NE(said.find("d0/Delta = 0.33"), std::string::npos) << said;
}
