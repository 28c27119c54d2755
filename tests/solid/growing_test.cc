#include <gtest/gtest.h>

#include "grown_scene.h"
#include "medium/area_map.h"
#include "solid/area_budget.h"
#include "solid/energy.h"

namespace
{
  using namespace solid;

  constexpr double width = 0.06, step = 0.002;
  const Point centre(1.013, 0.994);

  struct Disc
  {
    scene::Scene scene = grown::growing({2., 2.}, {40, 40});
    medium::Mesh mesh = medium::make_mesh(scene.domain);
    Owner owner = make_solid(scene);
    Solid &solid = *owner;
    double radius = 0.3, time = 0.;
    medium::Field<double> phi = grown::disc(mesh, centre, radius, width);

    Crystal crystal() const { return {phi, mesh, std::nullopt}; }
    void activate() { solid::activate(solid, crystal(), time); }
    void grow(const double by)
    {
      begin_growth(solid, crystal());
      radius += by, phi = grown::disc(mesh, centre, radius, width);
      seed_new_points(solid, crystal());
    }
    double largest_stress() const
    {
      double largest = 0.;
      for (std::size_t p = 0; p < solid.points.size(); ++p)
        largest = std::max({largest, std::abs(solid.points.sxx[p]), std::abs(solid.points.syy[p]),
                            std::abs(solid.points.sxy[p]), std::abs(solid.points.szz[p])});
      return largest;
    }
  };
} // namespace

TEST(Growing, HasNoPointBeforeActivation)
{
  Disc disc;
  EXPECT_FALSE(active(disc.solid));
  EXPECT_EQ(points(disc.solid), 0);
  disc.grow(0.01);
  EXPECT_EQ(points(disc.solid), 0);
}

TEST(Growing, ActivationGivesAllOfTheAreaToPointsAndLedger)
{
  Disc disc;
  disc.time = 3.;
  disc.activate();
  const AreaBudget now = area_budget(disc.solid);
  const double area = medium::solid_area(disc.phi, disc.mesh);
  EXPECT_NEAR(now.points + now.owed, area, 1e-10 * area);
  EXPECT_NEAR(mass(disc.solid), disc.solid.material.density * now.points, 1e-10 * area);
  EXPECT_LT(now.owed, 0.02 * area);
  EXPECT_EQ(time(disc.solid), 3.);
  EXPECT_EQ(disc.largest_stress(), 0.);
  EXPECT_THROW(disc.activate(), std::logic_error);
}

TEST(Growing, ADiscWithoutLoadStaysFreeOfStressAndItsMassFollowsItsArea)
{
  Disc disc;
  disc.activate();
  for (int k = 0; k < 100; ++k)
  {
    advance(disc.solid, 5. * stable_step(disc.solid));
    disc.grow(step);
  }
  const AreaBudget now = area_budget(disc.solid);
  const double area = medium::solid_area(disc.phi, disc.mesh);
  EXPECT_NEAR(now.points + now.owed, area, 1e-10 * area);
  EXPECT_NEAR(now.imbalance(), 0., 1e-10 * area);
  EXPECT_GT(now.seeded_points, 500);
  EXPECT_LT(disc.largest_stress(), 1e-9);
  // No cell of the inside has been left without points.
  std::vector<double> filled(40 * 40, 0.);
  for (std::size_t p = 0; p < disc.solid.points.size(); ++p)
    filled[disc.solid.grid.cell(disc.solid.points.y[p], 1) * 40 +
           disc.solid.grid.cell(disc.solid.points.x[p], 0)] += disc.solid.points.mass[p];
  const medium::CellAreas areas(disc.phi, disc.mesh);
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i)
      if (areas.corners(i, j) == 15u)
      {
        EXPECT_NEAR(filled[j * 40 + i], 0.05 * 0.05, 0.4 * 0.05 * 0.05) << i << ' ' << j;
      }
}

TEST(Growing, MeltingBackEmptiesIt)
{
  Disc disc;
  disc.activate();
  const double area = medium::solid_area(disc.phi, disc.mesh);
  for (int k = 0; k < 170; ++k)
  {
    disc.grow(-step);
    const AreaBudget now = area_budget(disc.solid);
    ASSERT_NEAR(now.imbalance(), 0., 1e-10 * area) << k;
    ASSERT_NEAR(now.points + now.owed, now.phi, 1e-10 * area) << k;
  }
  const AreaBudget now = area_budget(disc.solid);
  EXPECT_EQ(now.phi, 0.);
  EXPECT_EQ(points(disc.solid), 0);
  EXPECT_NEAR(now.melted, area, 1e-10 * area);
  EXPECT_NEAR(now.owed, 0., 1e-10 * area);
}

// phi melts the area that the strained solid covers, whatever its mass is without stress.
TEST(Growing, MeltingOfACompressedBodyTakesAwayTheAreaThatItCovers)
{
  Disc disc;
  disc.activate();
  for (std::size_t p = 0; p < disc.solid.points.size(); ++p)
    disc.solid.points.jacobian[p] = 0.9, disc.solid.points.mass[p] /= 0.9;
  const double covered = area(disc.solid), imbalance = area_budget(disc.solid).imbalance();
  for (int k = 0; k < 170; ++k)
  {
    disc.grow(-step);
    const AreaBudget now = area_budget(disc.solid);
    ASSERT_NEAR(area(disc.solid) + now.owed, now.phi, 1e-10 * covered) << k;
    ASSERT_NEAR(now.imbalance(), imbalance, 1e-10 * covered) << k;
  }
  EXPECT_EQ(points(disc.solid), 0);
  EXPECT_NEAR(area_budget(disc.solid).melted, covered / 0.9, 0.02 * covered);
}

// Cells that melt compete for points; who comes first must not depend on where it is counted from.
TEST(Growing, MeltingTakesTheSamePointsOnEitherSide)
{
  Disc disc;
  const auto melt = [&](const double size)
  {
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
      {
        const Point x = disc.mesh.position(i, j) - Point(1., 1.);
        const double shape = 1. + 0.2 * std::cos(6. * std::atan2(x[0], x[1]));
        disc.phi(i, j) = std::tanh((size * shape - x.norm()) / (std::sqrt(2.) * width));
      }
    medium::fill_ghosts(disc.phi, disc.mesh);
  };
  melt(0.7);
  disc.activate();
  for (int k = 1; k < 100; ++k)
  {
    begin_growth(disc.solid, disc.crystal());
    melt(0.7 - 0.006 * k);
    seed_new_points(disc.solid, disc.crystal());
    const Points &points = disc.solid.points;
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      double least = 1.;
      for (std::size_t q = 0; q < points.size(); ++q)
        least =
            std::min(least, std::hypot(2. - points.x[p] - points.x[q], points.y[p] - points.y[q]));
      ASSERT_LT(least, 1e-6) << "step " << k << ", " << points.x[p] << ", " << points.y[p];
    }
  }
}

TEST(Growing, AdvectionOfTheMarkerIsNoGrowth)
{
  Disc disc;
  disc.activate();
  const long before = points(disc.solid);
  disc.phi = grown::disc(disc.mesh, centre + Point(0.04, 0.03), disc.radius, width);
  begin_growth(disc.solid, disc.crystal());
  seed_new_points(disc.solid, disc.crystal());
  EXPECT_EQ(points(disc.solid), before);
  EXPECT_EQ(area_budget(disc.solid).grown, 0.);
  EXPECT_NEAR(area_budget(disc.solid).imbalance(), 0., 1e-13) << "debts are handed on, not lost";
}

TEST(Growing, NewPointsMoveWithTheSolidAndBringTheirEnergy)
{
  Disc disc;
  disc.activate();
  for (std::size_t p = 0; p < disc.solid.points.size(); ++p)
    disc.solid.points.vx[p] = 0.2, disc.solid.points.vy[p] = -0.1;
  disc.solid.energy.start = kinetic_energy(disc.solid);
  advance(disc.solid, stable_step(disc.solid));
  disc.grow(0.02);
  ASSERT_GT(area_budget(disc.solid).seeded_points, 20);
  for (std::size_t p = 0; p < disc.solid.points.size(); ++p)
  {
    ASSERT_NEAR(disc.solid.points.vx[p], 0.2, 1e-12);
    ASSERT_NEAR(disc.solid.points.vy[p], -0.1, 1e-12);
  }
  EXPECT_NEAR(disc.solid.energy.start, kinetic_energy(disc.solid), 1e-12);
}

TEST(Growing, GoesOnFromACheckpointToTheSameBits)
{
  Disc disc, other;
  disc.activate();
  disc.grow(0.013);
  advance(disc.solid, 3. * stable_step(disc.solid));
  restore(other.solid, checkpoint(disc.solid));
  other.radius = disc.radius, other.phi = disc.phi;
  for (Disc *d : {&disc, &other})
    for (int k = 0; k < 5; ++k)
    {
      advance(d->solid, 2. * stable_step(d->solid));
      d->grow(0.004);
    }
  EXPECT_EQ(checkpoint(disc.solid), checkpoint(other.solid));
}
