#include "melt/noise.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <omp.h>

#include "medium/sums.h"
#include "melt/growth.h"
#include "seed.h"

namespace
{
  using melt::Growth;
  using melt::Noise;
  using test::Boundary;
  using test::Field;
  using test::Mesh;

  constexpr double diffusivity = 3., strength = 1e-4, step = 0.002;

  Field<double> stirred(const Mesh &mesh, const Noise::Options &options, long steps, long cut = 0)
  {
    Field<double> theta(mesh);
    melt::GrowthOptions five;
    five.laplacian = scene::Laplacian::five_point;
    Growth growth(mesh, {1., 1., 0., 0., diffusivity}, five, 0.);
    const Noise noise(mesh, options);
    growth.advance({nullptr, &theta, nullptr, &noise}, step, cut);
    growth.advance({nullptr, &theta, nullptr, &noise}, step, steps - cut);
    return theta;
  }
} // namespace

// Known answers of Philox4x32-10 from the Random123 distribution (kat_vectors).
TEST(Philox, GivesThePublishedWords)
{
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(melt::philox({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u}));
  EXPECT_EQ(melt::philox({0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu},
                         {0xffffffffu, 0xffffffffu}),
            (Words{0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu}));
}

// Still periodic liquid: var = mean over k != 0 of (F/dx^2)/(1 - D h K/(2 dx^2)),
// K = 4 - 2 cos kx - 2 cos ky, from the recursion of each mode.
TEST(Noise, HasTheVarianceOfTheDiscreteFluctuationTheorem)
{
  const int cells = 64;
  const Mesh mesh = test::square_mesh(cells + 1, 0.4, Boundary::periodic);
  double expected = 0.;
  for (int a = 0; a < cells; ++a)
    for (int b = 0; b < cells; ++b)
      if (a || b)
      {
        const double k =
            4. - 2. * std::cos(2. * M_PI * a / cells) - 2. * std::cos(2. * M_PI * b / cells);
        expected += strength / 0.16 / (1. - diffusivity * step * k / 0.32);
      }
  expected /= cells * cells;
  // Samples 300 steps (0.6 time units) apart, after the slow modes had time to fill; long waves are
  // few, so that every sample counts nearly as cells^2 independent numbers.
  Field<double> theta(mesh);
  melt::GrowthOptions five;
  five.laplacian = scene::Laplacian::five_point;
  Growth growth(mesh, {1., 1., 0., 0., diffusivity}, five, 0.);
  const Noise noise(mesh, {strength, diffusivity, 11, false});
  growth.advance({nullptr, &theta, nullptr, &noise}, step, 4000);
  double variance = 0.;
  const int samples = 10;
  for (int sample = 0; sample < samples; ++sample)
  {
    growth.advance({nullptr, &theta, nullptr, &noise}, step, 300);
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        variance += theta(i, j) * theta(i, j);
  }
  variance /= samples * cells * cells;
  const double standard_error = expected * std::sqrt(2. / (samples * cells * cells));
  EXPECT_NEAR(variance, expected, 3. * standard_error);
}

TEST(Noise, MovesHeatWithoutMakingAny)
{
  for (const Boundary side : {Boundary::no_flux, Boundary::periodic})
  {
    const Mesh mesh = test::square_mesh(41, 0.4, side);
    const Field<double> theta = stirred(mesh, {strength, diffusivity, 3, false}, 500);
    EXPECT_NEAR(medium::weighted_sum(theta, mesh), 0., 1e-12);
    EXPECT_GT(std::abs(theta(5, 5)), 1e-4);
  }
}

TEST(Noise, HasTheSameBitsForAnyThreadsAndAfterARestart)
{
  const Mesh mesh = test::square_mesh(41, 0.4, Boundary::no_flux);
  const Noise::Options options{strength, diffusivity, 5, false};
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Field<double> one = stirred(mesh, options, 100);
  EXPECT_EQ(test::largest_difference(one, stirred(mesh, options, 100, 37), mesh), 0.);
  for (const int threads : {2, 3})
  {
    omp_set_num_threads(threads);
    EXPECT_EQ(test::largest_difference(one, stirred(mesh, options, 100), mesh), 0.);
  }
  omp_set_num_threads(before);
  Noise::Options other = options;
  other.seed = 6;
  EXPECT_GT(test::largest_difference(one, stirred(mesh, other, 100), mesh), 1e-3);
}

TEST(Noise, MirroredQuarterIsTheFoldedWhole)
{
  const Mesh whole = test::square_mesh(41, 0.4, Boundary::no_flux);
  const Mesh quarter = test::square_mesh(21, 0.4, Boundary::symmetry);
  const Noise::Options options{strength, diffusivity, 5, true};
  const Field<double> all = stirred(whole, options, 20), part = stirred(quarter, options, 20);
  for (int j = 0; j < 12; ++j) // away from the outer wall, whose own noise differs
    for (int i = 0; i < 12; ++i)
    {
      if (i + j < 20)
      {
        ASSERT_NEAR(all(20 - i, 20 + j), all(20 + i, 20 + j), 1e-15);
        ASSERT_NEAR(all(20 + i, 20 - j), all(20 + i, 20 + j), 1e-15);
      }
    }
  EXPECT_NEAR(all(20, 20), part(0, 0), 1e-6);
  EXPECT_NEAR(all(25, 22), part(5, 2), 1e-6);
}

TEST(Noise, RefusesASymmetrySideUnlessMirrored)
{
  const Mesh mesh = test::square_mesh(41, 0.4, Boundary::symmetry);
  EXPECT_THROW(Noise(mesh, {strength, diffusivity, 5, false}), std::invalid_argument);
  EXPECT_NO_THROW(Noise(mesh, {strength, diffusivity, 5, true}));
  const Mesh odd = test::square_mesh(42, 0.4, Boundary::no_flux);
  EXPECT_THROW(Noise(odd, {strength, diffusivity, 5, true}), std::invalid_argument);
}
