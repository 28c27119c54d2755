// What a plan counts before any step is taken.
#include "fe_reference/plan.h"

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace
{
  /// A square of side 1, its lower edge held, its upper edge moved to the right; yields at 1/200.
  scene::Scene sheared_square(const std::array<int, 2> &cells, const std::string &lower,
                              const std::string &upper)
  {
    scene::Scene scene = fe_test::solid_scene(200., cells, 2, 10);
    scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
    scene.solid->yield_stress = 1.;
    scene.supports.push_back(fe_test::support("lower", scene::Edge::bottom, lower, "0"));
    scene.supports.push_back(fe_test::support("upper", scene::Edge::top, upper, "0"));
    return scene;
  }

  double strains_of(const scene::Scene &scene)
  {
    return fe::yield_strains(fe_test::problem_of(scene), scene.clock.end, scene.fe->load_steps);
  }
} // namespace

TEST(PlanOfElements, CountsWhatSupportsMoveAgainstEachOtherInYieldStrainsOfACell)
{
  // 0.1 over cells of 1/2 and 1/4, yield strain 1/200.
  EXPECT_NEAR(strains_of(sheared_square({2, 2}, "0", "0.1*t")), 40., 1e-9);
  EXPECT_NEAR(strains_of(sheared_square({4, 4}, "0", "0.1*t")), 80., 1e-9);
  // There and back: the way counts, not where it ends.
  EXPECT_NEAR(strains_of(sheared_square({2, 2}, "0", "0.1*(0.5 - abs(t - 0.5))")), 40., 1e-9);
}

TEST(PlanOfElements, CountsNoStrainWhereAllMovesAlikeOrNothingYields)
{
  EXPECT_NEAR(strains_of(sheared_square({2, 2}, "0.1*t", "0.1*t")), 0., 1e-9);
  scene::Scene elastic = sheared_square({2, 2}, "0", "0.1*t");
  elastic.solid->yield_stress.reset();
  EXPECT_EQ(strains_of(elastic), 0.);
}
