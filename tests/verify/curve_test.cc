// What curves refuse and how they are cut: short histories, infinite samples, finely sampled loops.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "curve.h"

using namespace verify;

namespace
{
  // x goes to 1, back to 0 and to 1 again while t goes to 3
  Curve loop(const int rows)
  {
    Curve curve;
    for (int i = 0; i < rows; ++i)
    {
      const double t = 3. * i / (rows - 1);
      curve.t.push_back(t);
      curve.x.push_back(t < 1. ? t : t < 2. ? 2. - t : t - 2.);
      curve.y.push_back(t);
    }
    return curve;
  }

  Curve history(const double from, const double to)
  {
    Curve curve;
    for (int i = 0; i <= 10; ++i)
    {
      curve.t.push_back(from + 0.1 * i * (to - from));
      curve.x.push_back(curve.t.back());
      curve.y.push_back(1.);
    }
    return curve;
  }
} // namespace

// A row is then 6e-4 of the range: less than what counts as noise.
TEST(Curves, AreCutHoweverFinelyALoopIsSampled)
{
  const auto parts = branches(loop(5000));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0].x.back(), 1., 1e-3);
  EXPECT_NEAR(parts[1].x.back(), 0., 1e-3);
  EXPECT_NEAR(parts[2].x.back(), 1., 1e-12);
  EXPECT_EQ(branches(loop(300)).size(), 3u);
}

TEST(Curves, OfOneAbscissaAreOneBranch)
{
  EXPECT_EQ(branches({{2., 2., 2.}, {0., 1., 2.}, {0., 1., 2.}}).size(), 1u);
}

TEST(Curves, RefuseAStretchThatTheHistoryDoesNotReach)
{
  EXPECT_EQ(between(history(0., 1.), true, 0.2, 0.5).t.size(), 4u);
  EXPECT_EQ(between(history(0., 1.), true, 0., 1.).t.size(), 11u);
  EXPECT_NO_THROW(between(history(0., 1.), true, 0., 1.09)) << "less than a row is missing";
  EXPECT_THROW(between(history(0., 1.), true, 0.5, 1.2), MissingData);
  EXPECT_THROW(between(history(0.3, 1.), true, 0., 1.), MissingData);
  // a line that ends within the stretch is a body that ends there
  EXPECT_NO_THROW(between(history(0., 1.), false, 0.5, 1.2));
}

TEST(Reductions, RefuseInfiniteSamplesAndPassOverMissingOnes)
{
  const double infinite = std::numeric_limits<double>::infinity(), absent = std::nan("");
  const auto of = [](const double value) {
    return Curve{{0., 1., 2.}, {1., value, 3.}, {0., 0., 0.}};
  };
  for (const char *how : {"max", "min", "mean", "first", "last", "rms"})
  {
    EXPECT_THROW(reduce(of(infinite), how), MissingData) << how;
    EXPECT_THROW(reduce(of(-infinite), how), MissingData) << how;
  }
  EXPECT_NEAR(reduce(of(absent), "max"), 3., 1e-15);
}
