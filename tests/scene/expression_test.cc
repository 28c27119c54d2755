#include <cmath>

#include <gtest/gtest.h>

#include "scene/expression.h"
#include "scene/speed.h"

namespace
{
  scene::Function function(const std::string &text)
  {
    return scene::Function(scene::Expression{text, {"scene.toml", 7, "support.top.displacement"}});
  }

  double value(const std::string &text, const scene::Argument &argument = {})
  {
    return function(text)(argument);
  }
} // namespace

TEST(Expression, KnowsInitialAndCurrentPositionsApart)
{
  const scene::Argument a{{1., 2.}, {3., 4.}, 5.};
  EXPECT_EQ(value("X + 10*Y + 100*x + 1000*y + 10000*t", a), 1. + 20. + 300. + 4000. + 50000.);
}

TEST(Expression, KnowsPi)
{
  EXPECT_EQ(value("2*pi"), 2. * std::acos(-1.));
}

// Abramowitz and Stegun, Tables 5.1 and 7.1.
TEST(Expression, KnowsTheErrorFunctionAndTheExponentialIntegral)
{
  EXPECT_NEAR(value("erf(0.5)"), 0.5204998778, 1e-10);
  EXPECT_NEAR(value("erfc(0.5)"), 1. - 0.5204998778, 1e-10);
  EXPECT_NEAR(value("E1(0.5)"), 0.559773595, 1e-9);
  EXPECT_NEAR(value("E1(2.0)"), 0.048900511, 1e-9);
}

TEST(Expression, SaysWhatItDependsOn)
{
  EXPECT_TRUE(function("2*3").is_constant());
  EXPECT_FALSE(function("x").is_constant());
  EXPECT_FALSE(function("x").depends_on_time());
  EXPECT_TRUE(function("smooth(t, 2)").depends_on_time());
}

TEST(Expression, CopiesShareNothing)
{
  const scene::Function f = function("x");
  scene::Function g = f;
  EXPECT_EQ(f({{0., 0.}, {1., 0.}, 0.}), 1.);
  EXPECT_EQ(g({{0., 0.}, {2., 0.}, 0.}), 2.);
  g = function("y");
  EXPECT_EQ(g({{0., 0.}, {2., 3.}, 0.}), 3.);
}

// 6 s^5 - 15 s^4 + 10 s^3 at s = 1/4: 6/1024 - 15/256 + 10/64 = 106/1024.
TEST(SmoothRamp, IsTheQuinticStep)
{
  EXPECT_DOUBLE_EQ(value("smooth(1, 4)"), 106. / 1024.);
  EXPECT_EQ(value("smooth(-1, 4)"), 0.);
  EXPECT_EQ(value("smooth(5, 4)"), 1.);
  EXPECT_DOUBLE_EQ(value("smooth(2, 4)"), 0.5);
}

TEST(SmoothRamp, IsTheDerivativeOfRamp)
{
  const scene::Function ramp = function("ramp(t, 4)"), smooth = function("smooth(t, 4)");
  for (const double t : {0.5, 1., 2., 3.3, 3.9, 6.})
    EXPECT_NEAR(scene::time_derivative(ramp, {{}, {}, t}, 1e-3), smooth({{}, {}, t}), 1e-10) << t;
  EXPECT_DOUBLE_EQ(value("ramp(4, 4)"), 2.); // half of T is lost
  EXPECT_DOUBLE_EQ(value("ramp(10, 4)"), 8.);
}

// The fourth-order difference is exact for polynomials up to the fourth degree.
TEST(TimeDerivative, IsExactForQuartics)
{
  EXPECT_NEAR(scene::time_derivative(function("t^4"), {{}, {}, 2.}, 0.1), 32., 1e-11);
  EXPECT_EQ(scene::time_derivative(function("x"), {{}, {1., 1.}, 2.}, 0.1), 0.);
}

TEST(TimeDerivative, ConvergesAtFourthOrder)
{
  const scene::Function f = function("sin(t)");
  const auto error = [&](const double h) {
    return std::abs(scene::time_derivative(f, {{}, {}, 1.}, h) - std::cos(1.));
  };
  EXPECT_NEAR(std::log2(error(0.2) / error(0.1)), 4., 0.05);
}

TEST(Expression, NamesPlaceAndCauseWhenRefused)
{
  for (const char *text : {"0.4*s", "", "1 +", "x = 3", "1, 2", "1/0", "sin(x", "t t", "x += 1"})
    try
    {
      function(text);
      ADD_FAILURE() << text << " was accepted";
    }
    catch (const scene::BadScene &error)
    {
      EXPECT_NE(std::string(error.what()).find("scene.toml:7: support.top.displacement"),
                std::string::npos)
          << error.what();
    }
}

TEST(Expression, ComparesWithoutAssigning)
{
  EXPECT_EQ(value("t <= 1 ? 2 : 3"), 2.);
  EXPECT_EQ(value("t == 0 && x != 1 ? 2 : 3"), 2.);
}

// A short rise counts with its own slope, 15/8 of the mean at its middle, and no period hides
// between the times that are looked at.
TEST(LargestSpeed, IsFoundHoweverShortTheRise)
{
  const auto of = [](const std::string &text)
  {
    const scene::Function f = function(text);
    return scene::largest_speed(
        [&](const double t) {
          return scene::Point(f({scene::Point::Zero(), scene::Point::Zero(), t}), 0.);
        },
        100.);
  };
  EXPECT_EQ(of("0"), 0.);
  EXPECT_NEAR(of("0.3*t"), 0.3, 1e-12);
  EXPECT_NEAR(of("0.4*ramp(t, 5)"), 0.4, 1e-6);
  for (const std::string rise : {"30", "1", "0.1", "0.002"})
    EXPECT_NEAR(of("0.01*smooth(t - 37, " + rise + ")"), 0.01 * 1.875 / std::stod(rise),
                0.02 * 0.01 * 1.875 / std::stod(rise))
        << rise;
  for (const double cycles : {1., 400., 4000.})
  {
    const double frequency = 2. * std::acos(-1.) * cycles / 100.;
    EXPECT_NEAR(of("0.01*sin(" + std::to_string(frequency) + "*t)"), 0.01 * frequency,
                0.02 * 0.01 * frequency)
        << cycles;
  }
}
