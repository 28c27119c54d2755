// Skipping tiles, threads, precision and restarts must not change what is computed.
#include "melt/growth.h"

#include <gtest/gtest.h>
#include <omp.h>

#include "seed.h"

namespace
{
  using melt::Growth;
  using melt::GrowthOptions;
  using test::Boundary;
  using test::Mesh;

  const Mesh mesh = test::square_mesh(161, 0.4, Boundary::symmetry);

  test::Melt grown(const GrowthOptions &options, long steps, long cut = 0,
                   const melt::Orientation *orientation = nullptr)
  {
    test::Melt melt = test::seeded(mesh, {0., 0.}, 5., 0.55);
    Growth growth(mesh, test::paper_law(0.05), options, 0.55);
    const double h = 0.8 * growth.step_limit();
    growth.advance(melt.fields(orientation), h, cut);
    growth.advance(melt.fields(orientation), h, steps - cut);
    return melt;
  }

  GrowthOptions in(scene::Precision precision, bool tiles = true)
  {
    GrowthOptions options;
    options.precision = precision;
    options.tiles = tiles;
    return options;
  }
  constexpr auto in_double = scene::Precision::double_precision;
  constexpr auto in_single = scene::Precision::single_precision;
} // namespace

TEST(Tiles, SkippingChangesLessThanTheFlatness)
{
  const test::Melt all = grown(in(in_double, false), 1200), some = grown(in(in_double), 1200);
  EXPECT_LT(test::largest_difference(all.phi, some.phi, mesh), 1e-10);
  EXPECT_LT(test::largest_difference(all.theta, some.theta, mesh), 1e-10);
}

TEST(Tiles, AreFrozenHeatOnlyAndActiveWhereTheyShouldBe)
{
  test::Melt melt = test::seeded(mesh, {0., 0.}, 5., 0.55);
  Growth growth(mesh, test::paper_law(0.05), GrowthOptions{}, 0.55);
  growth.advance(melt.fields(), 0.8 * growth.step_limit(), 17);
  const medium::Tiles &tiles = growth.tiles();
  EXPECT_EQ(tiles.at(0, 1), medium::Activity::active);
  EXPECT_EQ(tiles.at(tiles.columns - 1, tiles.rows - 1), medium::Activity::frozen);
  EXPECT_GT(tiles.count(medium::Activity::heat_only), 0);
  EXPECT_LT(tiles.count(medium::Activity::active), static_cast<long>(tiles.activity.size()) / 4);
}

TEST(Threads, GiveTheSameBits)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const test::Melt one = grown(GrowthOptions{}, 400);
  for (const int threads : {2, 3})
  {
    omp_set_num_threads(threads);
    const test::Melt many = grown(GrowthOptions{}, 400);
    EXPECT_EQ(test::largest_difference(one.phi, many.phi, mesh), 0.);
    EXPECT_EQ(test::largest_difference(one.theta, many.theta, mesh), 0.);
  }
  omp_set_num_threads(before);
}

// Calls may be cut anywhere that the tiles are judged; elsewhere the cut judges them once more.
TEST(Calls, CutAtAJudgementGiveTheSameBitsAndElsewhereTheFlatness)
{
  for (const auto precision : {in_double, in_single})
  {
    const test::Melt whole = grown(in(precision), 400), cut = grown(in(precision), 400, 160);
    EXPECT_EQ(test::largest_difference(whole.phi, cut.phi, mesh), 0.);
    EXPECT_EQ(test::largest_difference(whole.theta, cut.theta, mesh), 0.);
  }
  const test::Melt whole = grown(GrowthOptions{}, 400), odd = grown(GrowthOptions{}, 400, 173);
  EXPECT_LT(test::largest_difference(whole.phi, odd.phi, mesh), 1e-10);
}

TEST(SinglePrecision, FollowsDouble)
{
  const test::Melt fine = grown(in(in_double), 1200), coarse = grown(in(in_single), 1200);
  // The front has moved 10 W0; its slope is at most 1/sqrt(2) per W0.
  EXPECT_LT(test::largest_difference(fine.phi, coarse.phi, mesh), 2e-3);
  EXPECT_LT(test::largest_difference(fine.theta, coarse.theta, mesh), 1e-3);
}

TEST(AngleField, OfOneValueIsTheUniformAngle)
{
  for (const double degrees : {0., 15., 45.})
  {
    melt::Orientation uniform = melt::make_orientation(degrees);
    const test::Melt plain = grown(GrowthOptions{}, 400, 0, &uniform);
    melt::allocate_angle_field(uniform, mesh);
    melt::refresh(uniform, mesh);
    const test::Melt field = grown(GrowthOptions{}, 400, 0, &uniform);
    EXPECT_LT(test::largest_difference(plain.phi, field.phi, mesh), 1e-11);
  }
}
