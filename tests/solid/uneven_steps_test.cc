// Steps of unlike lengths, as rows to be recorded make them.
#include <gtest/gtest.h>

#include <utility>

#include "small_scenes.h"

namespace
{
  double energy(const solid::Solid &solid)
  {
    const solid::History history = solid::history(solid);
    return small::value_of(history, "kinetic_energy") + small::value_of(history, "elastic_energy");
  }

  /// A strip between rollers that is pushed at one end, a point a cell. Its energy over the work of
  /// the push after 600 pairs of steps, as parts of the limit.
  double gained_in_pairs(const double one, const double other)
  {
    scene::Scene scene = small::rectangle({1., 1.}, {10., 0.5}, {13., 2.5}, {260, 50});
    small::hold(scene, "left", scene::Edge::left, "1e-3*ramp(t, 0.07)", {});
    small::hold(scene, "bottom", scene::Edge::bottom, {}, "0");
    small::hold(scene, "top", scene::Edge::top, {}, "0");
    scene.mpm->points_per_cell = {1, 1}, scene.mpm->step_fraction = 1.;
    const solid::Owner strip = solid::make_solid(scene);
    const double limit = 0.999 * solid::stable_step(*strip);
    for (int pair = 0; pair < 600; ++pair)
    {
      solid::advance(*strip, one * limit);
      solid::advance(*strip, other * limit);
    }
    return energy(*strip) / small::value_of(solid::history(*strip), "external_work");
  }
} // namespace

// With omega dt = 2 at the limit, steps a and b in turn are stable if (a + b)^2 - a^2 b^2 < 4: as
// they are asked for here, none of the three pairs is (4.1, 4.4 and 5.0).
// Waves in a strip lose a little between points and grid.
TEST(UnevenSteps, PairsWithinTheLimitGainNoEnergy)
{
  for (const auto &[one, other] :
       {std::pair(0.85, 0.25), std::pair(0.85, 0.4), std::pair(0.95, 0.4)})
  {
    const double gained = gained_in_pairs(one, other);
    EXPECT_LT(gained, 1.001) << one << " and " << other;
    EXPECT_GT(gained, 0.98) << one << " and " << other;
  }
}

// Equal ones are, to the limit: nothing is taken from them.
TEST(UnevenSteps, EqualStepsGoToTheLimit)
{
  scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {12, 12});
  scene.mpm->step_fraction = 0.95;
  const solid::Owner block = solid::make_solid(scene);
  solid::advance(*block, 10. * solid::stable_step(*block));
  EXPECT_EQ(solid::steps(*block), 10);
}
