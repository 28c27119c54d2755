// The arithmetic of verify: grid convergence, curves, norms, outlines, expressions.
#include <cmath>

#include <gtest/gtest.h>

#include "curve.h"
#include "formula.h"
#include "grids.h"
#include "norm.h"
#include "outline_measure.h"
#include "section.h"

using namespace verify;

namespace
{
  const double infinite = std::numeric_limits<double>::infinity();
  const double absent = std::numeric_limits<double>::quiet_NaN();

  Curve sampled(int n, double (*f)(double), double from = 0., double to = 1.)
  {
    Curve curve;
    for (int i = 0; i <= n; ++i)
    {
      const double x = from + (to - from) * i / n;
      curve.x.push_back(x);
      curve.t.push_back(x);
      curve.y.push_back(f(x));
    }
    return curve;
  }
  double square(double x)
  {
    return x * x;
  }
  double line(double x)
  {
    return 3. * x - 1.;
  }
  Outline box(double x0, double y0, double x1, double y1)
  {
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  }
} // namespace

// The example of NASA's verification pages: p = 1.78617, f(0) = 0.971300, GCI 0.10308 % and 0.35625
// %.
TEST(GridConvergence, GivesTheKnownAnswer)
{
  const std::vector<double> h{1., 2., 4.}, f{0.97050, 0.96854, 0.96178};
  const auto fine = grid_uncertainty(h, f, 0, 2.), middle = grid_uncertainty(h, f, 1, 2.);
  ASSERT_TRUE(fine.monotone);
  EXPECT_NEAR(fine.order, 1.78617, 1e-5);
  EXPECT_NEAR(*fine.limit, 0.971300, 1e-6);
  EXPECT_NEAR(100. * fine.uncertainty / f[0], 0.10308, 1e-5);
  EXPECT_NEAR(100. * middle.uncertainty / f[1], 0.35625, 1e-5);
}

TEST(GridConvergence, DoesNotMindTheOrderOfGridsNorUnequalRatios)
{
  // f = 1 + 0.1 h^1.5
  const std::vector<double> h{1.0, 0.25, 0.4};
  std::vector<double> f;
  for (const double v : h)
    f.push_back(1. + 0.1 * std::pow(v, 1.5));
  const auto result = grid_uncertainty(h, f, 1, 2.);
  EXPECT_NEAR(result.order, 1.5, 1e-9);
  EXPECT_NEAR(*result.limit, 1., 1e-12);
  EXPECT_NEAR(result.uncertainty, 1.25 * 0.1 * std::pow(0.25, 1.5), 1e-12);
}

TEST(GridConvergence, TakesTheSpreadWhereGridsAreNotMonotone)
{
  const auto result = grid_uncertainty({1., 2., 4.}, {1.0, 1.2, 1.1}, 0, 2.);
  EXPECT_FALSE(result.monotone);
  EXPECT_NEAR(result.uncertainty, 1.25 * 0.2, 1e-12);
  EXPECT_NE(result.text().find("not monotone"), std::string::npos);
}

TEST(GridConvergence, DoesNotBelieveAnOrderAboveTheFormalOne)
{
  // f = h^4: the index may only count on h^2
  const auto result = grid_uncertainty({1., 2., 4.}, {1., 16., 256.}, 0, 2.);
  EXPECT_NEAR(result.order, 4., 1e-9);
  EXPECT_NEAR(result.uncertainty, 1.25 * 15. / 3., 1e-9);
}

// 1, 2, 3.1: order 0.14, which would extrapolate to -9; the three differ by 2.1.
TEST(GridUncertainty, OfAnOrderFarBelowOneIsBoundByTheSpread)
{
  const auto result = grid_uncertainty({1., 2., 4.}, {1., 2., 3.1}, 0, 2.);
  EXPECT_NEAR(result.order, std::log2(1.1), 1e-9);
  EXPECT_NEAR(result.uncertainty, 1.25 * 2.1, 1e-9);
}

TEST(ObservedOrder, IsTheSlopeAndRefusesZeroErrors)
{
  EXPECT_NEAR(observed_order({0.1, 0.2, 0.4}, {2e-3, 8e-3, 3.2e-2}), 2., 1e-12);
  EXPECT_THROW(observed_order({0.1, 0.2}, {0., 1e-3}), MissingData);
}

TEST(Curves, InterpolateOnlyInsideTheirSamples)
{
  const Curve curve = sampled(4, line);
  EXPECT_NEAR(interpolate(curve, 0.33), line(0.33), 1e-14);
  EXPECT_NEAR(interpolate(curve, 1.0 + 1e-12), line(1.), 1e-9);
  EXPECT_TRUE(std::isnan(interpolate(curve, 1.01)));
}

TEST(Curves, AreCutWhereALoopTurnsRound)
{
  Curve loop;
  for (int i = 0; i <= 300; ++i)
  {
    const double t = 0.01 * i;
    loop.t.push_back(t);
    loop.x.push_back(t < 1. ? t : t < 2. ? 2. - t : t - 2.);
    loop.y.push_back(t);
  }
  const auto parts = branches(loop);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[1].x.front(), 1., 1e-12);
  EXPECT_NEAR(parts[1].x.back(), 0., 1e-12);
  // the same loop sampled elsewhere agrees branch by branch
  Curve coarse;
  for (const double t : {0., 0.3, 0.995, 1., 1.4, 1.99, 2., 2.5, 3.})
  {
    coarse.t.push_back(t);
    coarse.x.push_back(t < 1. ? t : t < 2. ? 2. - t : t - 2.);
    coarse.y.push_back(t);
  }
  EXPECT_NEAR(distance({"max", {}, 0.99}, loop, coarse, coarse), 0., 1e-9);
}

TEST(Curves, IgnoreNoiseOfTheAbscissa)
{
  Curve noisy = sampled(1000, line);
  for (std::size_t i = 0; i < noisy.x.size(); i += 2)
    noisy.x[i] += 5e-4;
  EXPECT_EQ(branches(noisy).size(), 1u);
}

TEST(Norms, AreOrderedAndNormalised)
{
  const Curve a = sampled(100, [](double x) { return square(x) + 0.1; }), b = sampled(100, square);
  EXPECT_NEAR(distance({"max", {}, 0.99}, a, b, b), 0.1, 1e-12);
  EXPECT_NEAR(distance({"rms", {}, 0.99}, a, b, b), 0.1, 1e-12);
  EXPECT_NEAR(distance({"relative_max", {}, 0.99}, a, b, b), 0.1, 1e-12);
  EXPECT_NEAR(distance({"max", 4., 0.99}, a, b, b), 0.025, 1e-12);
  // relative_l2: 0.1/sqrt(integral x^4) = 0.1 sqrt(5)
  EXPECT_NEAR(distance({"relative_l2", {}, 0.99}, a, b, b), 0.1 * std::sqrt(5.), 1e-4);
  EXPECT_NEAR(distance({"relative", {}, 0.}, 3., 4., 4.), 0.25, 1e-15);
  EXPECT_NEAR(distance({"relative", {}, 0.}, 5., 4., 4.), 0.25,
              1e-15); // unsigned: both sides count
}

TEST(Norms, RefuseAScaleOfZero)
{
  EXPECT_NEAR(distance({"absolute", 2., 0.}, 3., 4., 4.), 0.5, 1e-15);
  EXPECT_THROW(distance({"absolute", 0., 0.}, 3., 4., 4.), MissingData);
}

TEST(Norms, RefuseShortInfiniteAndUnlikeData)
{
  const Curve whole = sampled(100, square), half = sampled(50, square, 0., 0.5);
  EXPECT_THROW(distance({"max", {}, 0.99}, half, whole, whole), MissingData);
  EXPECT_THROW(distance({"max", {}, 0.99}, whole, half, half), MissingData);
  Curve broken = whole;
  broken.y[7] = infinite;
  EXPECT_THROW(distance({"max", {}, 0.}, broken, whole, whole), MissingData);
  EXPECT_THROW(distance({"max", {}, 0.99}, 1., whole, whole), MissingData);
  EXPECT_THROW(distance({"relative", {}, 0.99}, 1., 0., 0.), MissingData);
  EXPECT_THROW(distance({"absolute", {}, 0.99}, absent, 0., 0.), MissingData);
}

TEST(Norms, LeaveOutMissingPointsButCountThem)
{
  Curve a = sampled(100, square);
  const Curve b = a;
  a.y[0] = a.y[1] = absent;
  EXPECT_NEAR(distance({"max", {}, 0.95}, a, b, b), 0., 1e-15);
  EXPECT_THROW(distance({"max", {}, 0.995}, a, b, b), MissingData);
}

TEST(Reductions, GiveExactValuesOfALine)
{
  const Curve curve = sampled(10, line);
  EXPECT_NEAR(reduce(curve, "max"), 2., 1e-14);
  EXPECT_NEAR(reduce(curve, "min"), -1., 1e-14);
  EXPECT_NEAR(reduce(curve, "max_abs"), 2., 1e-14);
  EXPECT_NEAR(reduce(curve, "range"), 3., 1e-14);
  EXPECT_NEAR(reduce(curve, "mean"), 0.5, 1e-14);
  EXPECT_NEAR(reduce(curve, "integral"), 0.5, 1e-14);
  EXPECT_NEAR(reduce(curve, "slope"), 3., 1e-13);
  EXPECT_NEAR(reduce(curve, "ripple"), 0., 1e-13);
  EXPECT_THROW(reduce({{0.}, {absent}, {0.}}, "max"), MissingData);
}

TEST(Outlines, HaveAreaSidesAndDistances)
{
  const Outline unit = box(0., 0., 1., 1.), moved = box(0.1, 0., 1.1, 1.);
  EXPECT_NEAR(area(unit), 1., 1e-14);
  EXPECT_NEAR(perimeter(unit), 4., 1e-14);
  EXPECT_NEAR(side_position(moved, "left", 0.9), 0.1, 1e-14);
  EXPECT_NEAR(side_position(moved, "right", 0.5), 1.1, 1e-14);
  EXPECT_NEAR(side_position(moved, "top", 0.5), 1.0, 1e-14);
  EXPECT_NEAR(symmetric_difference(unit, moved), 0.2, 1e-12);
  EXPECT_NEAR(hausdorff(unit, moved), 0.1, 1e-12);
  // Half of the vertices of each lie on the other's edges, the other half 0.1 away.
  EXPECT_NEAR(rms_distance(unit, moved), std::sqrt(0.5) * 0.1, 1e-12);
  EXPECT_NEAR(symmetric_difference(shifted(unit, {0.1, 0.}), moved), 0., 1e-12);
  EXPECT_THROW(side_position(unit, "left", 2.), MissingData);
  EXPECT_THROW(area({}), MissingData);
}

// A parallelogram that is its own image under half a turn, and not in a mirror: at height y the two
// span [y - 2, y + 2] and [-y - 2, -y + 2], so that 4 |y| lies in one of them only, 4 in sum.
TEST(Outlines, AreMirroredWhereTurningWillNotDo)
{
  const Outline right = {{{-3., -1.}, {1., -1.}, {3., 1.}, {-1., 1.}}},
                left = {{{-1., -1.}, {3., -1.}, {1., 1.}, {-3., 1.}}};
  EXPECT_NEAR(symmetric_difference(rotated(right, 180.), right), 0., 1e-12);
  EXPECT_NEAR(symmetric_difference(right, left), 4., 1e-12);
  EXPECT_NEAR(symmetric_difference(mirrored(right, "x"), left), 0., 1e-12);
  EXPECT_NEAR(symmetric_difference(mirrored(right, "y"), left), 0., 1e-12);
  const Outline corner = box(1., 2., 2., 4.);
  EXPECT_NEAR(symmetric_difference(mirrored(corner, "x"), box(-2., 2., -1., 4.)), 0., 1e-12);
  EXPECT_NEAR(symmetric_difference(mirrored(corner, "y"), box(1., -4., 2., -2.)), 0., 1e-12);
}

TEST(Outlines, TakeHolesOffWhicheverWayTheyRun)
{
  Outline ring = box(0., 0., 2., 2.);
  ring.push_back({{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}});
  EXPECT_NEAR(area(ring), 3., 1e-12);
  EXPECT_NEAR(symmetric_difference(ring, box(0., 0., 2., 2.)), 1., 1e-12);
}

// Abramowitz and Stegun, Tables 5.1 and 7.1.
TEST(Formulas, KnowTheFunctionsOfDiffusion)
{
  EXPECT_NEAR(evaluate("erf(0.5) + 2*erfc(0.5)", {}), 2. - 0.5204998778, 1e-9);
  EXPECT_NEAR(evaluate("E1(0.5)", {}), 0.559773595, 1e-9);
}

TEST(Formulas, KnowConstantsAndColumnsAndNameWhatIsMissing)
{
  EXPECT_NEAR(evaluate("a^2/2", {{"a", 3.}}), 4.5, 1e-15);
  const ColumnData columns{{"force", {2., 4.}}};
  EXPECT_EQ(evaluate("force/a", {{"a", 2.}}, columns), (std::vector<double>{1., 2.}));
  try
  {
    evaluate("forse", {}, columns);
    FAIL() << "an unknown column was accepted";
  }
  catch (const MissingData &error)
  {
    EXPECT_NE(std::string(error.what()).find("force"), std::string::npos) << error.what();
  }
  EXPECT_THROW(evaluate("a +", {{"a", 1.}}), BadInput);
}
