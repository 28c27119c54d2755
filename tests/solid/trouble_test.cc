// What stops a run: every message, each brought about on purpose and seen within a few steps.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "small_scenes.h"
#include "solid/body.h"
#include "solid/energy.h"

namespace
{
  using scene::Edge;
  using scene::Point;

  /// A free elastic block of five by five cells in the middle of 15 by 15, wave speed 36.7.
  scene::Scene block()
  {
    return small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {15, 15});
  }

  void push(scene::Scene &scene, const std::string &x)
  {
    scene.body_force.emplace();
    scene.body_force->acceleration = {small::text(x), small::text("0")};
  }

  /// What stops it before `steps` more are done; "" if nothing does.
  std::string stopped_within(solid::Solid &solid, const long steps)
  {
    const long first = solid::steps(solid);
    try
    {
      while (solid::steps(solid) < first + steps)
        solid::advance(solid, 0.999 * solid::stable_step(solid));
    }
    catch (const solid::NumericalError &trouble)
    {
      EXPECT_EQ(trouble.step, solid::steps(solid));
      EXPECT_EQ(trouble.time, solid.time);
      return trouble.what();
    }
    return "";
  }

  bool says(const std::string &message, const std::string &words)
  {
    return message.find(words) != std::string::npos;
  }

  /// Takes all of the scene's block along and leaves its stress as it is.
  void drive(scene::Scene &scene, const std::string &x, const std::string &y)
  {
    small::hold(scene, "all", scene::Box{{0.9, 0.9}, {2.1, 2.1}}, x, y);
  }

  void scale(solid::Array<double> &array, const double factor)
  {
    for (double &value : array)
      value *= factor;
  }
} // namespace

// A body force that is no number from some time on.
TEST(NumericalError, APointThatIsNoLongerFiniteIsFoundAtOnce)
{
  scene::Scene scene = block();
  push(scene, "sqrt(0.01 - t)");
  const solid::Owner owner = solid::make_solid(scene);
  const std::string message = stopped_within(*owner, 20);
  EXPECT_TRUE(says(message, "is no longer finite")) << message;
  EXPECT_GT(owner->time, 0.01);
  EXPECT_LT(owner->time, 0.01 + 3. * 0.4 * 0.2 / owner->material.wave_speed());
}

TEST(NumericalError, AStressThatIsNoNumberIsFoundAtOnce)
{
  const solid::Owner owner = solid::make_solid(block());
  ASSERT_EQ(stopped_within(*owner, 3), "");
  owner->points.sxx[7] = std::numeric_limits<double>::quiet_NaN();
  const std::string message = stopped_within(*owner, 1);
  EXPECT_TRUE(says(message, "is no longer finite")) << message;
}

// Supports at either end that are driven through each other.
TEST(NumericalError, APointTurnedInsideOutIsFoundBeforeTheEndsHavePassed)
{
  scene::Scene scene = block();
  small::hold(scene, "left", Edge::left, "0", "0");
  small::hold(scene, "right", Edge::right, "-200*t", "0");
  const solid::Owner owner = solid::make_solid(scene);
  const std::string message = stopped_within(*owner, 200);
  EXPECT_TRUE(says(message, "is turned inside out")) << message;
  EXPECT_LT(owner->time, 1. / 200.);
}

// As much in a step as would take the block across a cell.
TEST(NumericalError, APointThatIsTooFastForTheStepIsFoundAtOnce)
{
  scene::Scene scene = block();
  push(scene, "t < 0.01 ? 0 : 1e5");
  const solid::Owner owner = solid::make_solid(scene);
  const std::string message = stopped_within(*owner, 20);
  EXPECT_TRUE(says(message, "crosses half a cell in one step")) << message;
  EXPECT_LT(owner->time, 0.01 + 3. * 0.4 * 0.2 / owner->material.wave_speed());
}

TEST(NumericalError, MotionFromNowhereIsFoundAtOnce)
{
  scene::Scene scene = block();
  scene.bodies[0].velocity[0] = small::text("0.1");
  const solid::Owner owner = solid::make_solid(scene);
  ASSERT_EQ(stopped_within(*owner, 10), "");
  scale(owner->points.vx, 1.3); // 1.69 of the energy is doubted only at the end of the run
  EXPECT_EQ(stopped_within(*owner, 3), "");
  scale(owner->points.vx, 1.3);
  const std::string message = stopped_within(*owner, 1);
  EXPECT_TRUE(says(message, "the kinetic energy exceeds twice all that was ever put in"))
      << message;
}

// Driven as a whole: whatever the stresses do, nothing gets faster.
TEST(NumericalError, StressFromNowhereIsFoundWithinThirtyTwoSteps)
{
  for (const double factor : {1.2, 1.5})
  {
    scene::Scene scene = block();
    scene.bodies[0].initial_stress = {
        {small::text("0"), small::text("0"), small::text("0"), small::text("1")}};
    drive(scene, "0.001*t + 1e-9*t*X", "0"); // hardly any motion beside the stress
    const solid::Owner owner = solid::make_solid(scene);
    ASSERT_EQ(stopped_within(*owner, 100), "");
    scale(owner->points.sxy, factor);
    const std::string message = stopped_within(*owner, 32);
    if (factor * factor < 2.)
      EXPECT_EQ(message, "");
    else
      EXPECT_TRUE(says(message, "the energy of motion and stress exceeds twice")) << message;
  }
}

// Whenever it comes, also just before the account is drawn up: in its first step the stress is
// there before its work.
TEST(NumericalError, ALoadThatSetsInIsNoStressFromNowhere)
{
  for (int begin = 60; begin <= 66; ++begin)
  {
    scene::Scene scene = block();
    const double dt = 0.4 * 0.2 / solid::make_solid(scene)->material.wave_speed();
    const std::string onset = std::to_string((begin + 0.5) * 0.999 * dt);
    drive(scene, "0.01*max(t - " + onset + ", 0)*(X - 1.5)", "0");
    const solid::Owner owner = solid::make_solid(scene);
    EXPECT_EQ(stopped_within(*owner, 160), "") << begin;
    EXPECT_GT(solid::elastic_energy(*owner), 0.);
  }
}
