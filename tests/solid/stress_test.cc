#include <gtest/gtest.h>

#include "solid/stress.h"

using solid::Flow;
using solid::Increment;
using solid::Stress;

namespace
{
  constexpr double E = 3e7, nu = 0.3, yield = 6e4, pi = 3.14159265358979323846;
  constexpr double G = E / (2. * (1. + nu)), K = E / (3. * (1. - 2. * nu));

  Stress step(const Stress &s, const Increment &e, const double viscosity_rate)
  {
    return solid::update<true>(s, e, e.xx + e.yy, Flow{G, K, yield, viscosity_rate}).stress;
  }

  // Plane strain, sigma_xx = 0, pulled along y at a constant rate to `strain`.
  Stress pull(const double rate, const double viscosity, const double strain, const int steps)
  {
    Stress s{};
    const double dt = strain / rate / steps;
    for (int k = 0; k < steps; ++k)
    {
      double a = 0., b = -strain / steps;
      const auto sxx = [&](const double exx) {
        return step(s, {exx, strain / steps, 0., 0.}, viscosity / dt).xx;
      };
      for (int iteration = 0; iteration < 40 && std::abs(b - a) > 1e-18; ++iteration)
      {
        const double fa = sxx(a), fb = sxx(b), next = fb == fa ? b : b - fb * (b - a) / (fb - fa);
        a = b, b = next;
      }
      s = step(s, {b, strain / steps, 0., 0.}, viscosity / dt);
    }
    return s;
  }

  Stress turned_by(const Stress &s, const double angle)
  {
    const double c = std::cos(angle), d = std::sin(angle);
    return {c * c * s.xx + d * d * s.yy - 2. * c * d * s.xy,
            d * d * s.xx + c * c * s.yy + 2. * c * d * s.xy, s.zz,
            c * d * (s.xx - s.yy) + (c * c - d * d) * s.xy};
  }
} // namespace

TEST(Hooke, PlaneStrainHasTheConfinedModulus)
{
  const Stress s = step({}, {1e-4, 0., 0., 0.}, 0.);
  EXPECT_NEAR(s.xx, (K + 4. / 3. * G) * 1e-4, 1e-9);
  EXPECT_NEAR(s.yy, (K - 2. / 3. * G) * 1e-4, 1e-9);
  EXPECT_NEAR(s.zz, s.yy, 1e-9);
}

TEST(RadialReturn, LeavesElasticStateBelowYield)
{
  const double exy = 0.99 * yield / std::sqrt(3.) / (2. * G);
  const solid::Updated to = solid::update<true>({}, {0., 0., exy, 0.}, 0., Flow{G, K, yield, 0.});
  EXPECT_EQ(to.plastic, 0.);
  EXPECT_NEAR(solid::von_mises(to.stress), 0.99 * yield, 1e-6);
}

TEST(RadialReturn, EndsOnTheYieldSurfaceAndKeepsThePressure)
{
  const Increment e{2e-2, -1e-2, 3e-2, 0.};
  const solid::Updated to = solid::update<true>({}, e, e.xx + e.yy, Flow{G, K, yield, 0.});
  EXPECT_NEAR(solid::von_mises(to.stress) / yield, 1., 1e-13);
  EXPECT_NEAR(solid::pressure(to.stress), -K * 1e-2, 1e-6);
  // d gamma = (q_trial - sigma_Y)/3G with q_trial of the elastic trial.
  const Stress trial = solid::update<false>({}, e, e.xx + e.yy, Flow{G, K, yield, 0.}).stress;
  EXPECT_NEAR(to.plastic, (solid::von_mises(trial) - yield) / (3. * G), 1e-12);
}

TEST(RadialReturn, IsElasticForInfiniteViscosityAndOverstressedBetween)
{
  const Increment e{0., 0., 1e-2, 0.};
  const auto q = [&](const double viscosity_rate)
  { return solid::von_mises(step({}, e, viscosity_rate)); };
  EXPECT_NEAR(q(1e20) / (2. * G * 1e-2 * std::sqrt(3.)), 1., 1e-9);
  EXPECT_GT(q(G), yield * 1.01);
}

// Table of the dossier (section 6): plane strain with free sides, independent 0-D integration.
TEST(Perzyna, FollowsTheZeroDimensionalTable)
{
  EXPECT_NEAR(pull(5e-3, 3e6, 0.0025, 2000).yy, 77866., 0.001 * 77866.);
  EXPECT_NEAR(pull(5e-3, 3e6, 0.01, 4000).yy, 89215., 0.001 * 89215.);
  EXPECT_NEAR(solid::von_mises(pull(1e-2, 3e6, 0.005, 4000)), 90598., 0.001 * 90598.);
}

TEST(Perzyna, WithoutViscositySaturatesAtTwoOverRootThree)
{
  const Stress s = pull(1e-3, 0., 0.02, 2000);
  EXPECT_NEAR(s.yy, 2. / std::sqrt(3.) * yield, 1e-3 * yield);
  EXPECT_NEAR(s.zz, 0.5 * s.yy, 2e-3 * yield);
}

TEST(HughesWinget, TurnsStressExactlyWithTheMaterial)
{
  const Stress first{3e4, -1e4, 5e3, 2e4};
  const int steps = 37;
  const double angle = 0.5 * pi / steps;
  Stress s = first;
  for (int k = 0; k < steps; ++k)
  {
    // Displacement increments of a rotation by `angle`: L = R - I over a step of length 1.
    const double c = std::cos(angle) - 1., d = std::sin(angle);
    const Increment e = solid::increment(c, -d, d, c, 1.);
    EXPECT_NEAR(e.xx, 0., 1e-16);
    // The Cayley transform of the mid-step spin 2 tan(angle/2) is the rotation by `angle`.
    s = solid::update<false>(s, e, e.xx + e.yy, Flow{G, K, 0., 0.}).stress;
  }
  const Stress expected = turned_by(first, 0.5 * pi);
  EXPECT_NEAR(s.xx, expected.xx, 1e-6);
  EXPECT_NEAR(s.yy, expected.yy, 1e-6);
  EXPECT_NEAR(s.xy, expected.xy, 1e-6);
  EXPECT_NEAR(s.zz, expected.zz, 1e-6);
}

TEST(Jaumann, SimpleShearOscillates)
{
  const double gamma = 1.3;
  const auto error = [&](const int steps)
  {
    Stress s{};
    for (int k = 0; k < steps; ++k)
    {
      const Increment e = solid::increment(0., gamma / steps, 0., 0., 1.);
      s = solid::update<false>(s, e, e.xx + e.yy, Flow{G, K, 0., 0.}).stress;
    }
    return std::hypot(s.xy - G * std::sin(gamma), s.xx - G * (1. - std::cos(gamma))) / G;
  };
  EXPECT_LT(error(1000), 2e-3);
  EXPECT_NEAR(error(1000) / error(2000), 2., 0.1); // first order: the increment is not turned
}
