// A half or a quarter of a symmetric body does what it does as a part of the whole.
#include "solid/mirrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "small_scenes.h"
#include "solid/body.h"

namespace
{
  using solid::Point;

  struct Scheme
  {
    scene::ShapeFunction shape;
    scene::Transfer transfer;
    scene::StressUpdate update;
  };
  class Mirrors : public testing::TestWithParam<Scheme>
  {
  };

  void cut(scene::Scene &scene, const scene::Edge side)
  {
    scene.domain.boundary[static_cast<int>(side)] = scene::Boundary::symmetry;
  }

  scene::Scene crossed_bars(const Scheme &scheme, const Point &lower, const Point &size,
                            const std::array<int, 2> &cells)
  {
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, size, cells);
    scene.domain.lower = lower;
    // On the lattice of points, whose places are then the same numbers in the part and the whole;
    // at the ends of its arms nodes on the axes have hardly any mass.
    scene.bodies[0].shape = scene::Rectangle{{-3., -1.}, {6., 2.}};
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "upright",
    scene.bodies[1].shape = scene::Rectangle{{-1., -2.5}, {2., 5.}};
    for (scene::Body &body : scene.bodies)
      body.velocity = {small::text("-0.6*x"), small::text("0.8*y")};
    scene.solid->yield_stress = 5.;
    scene.mpm->shape_function = scheme.shape, scene.mpm->transfer = scheme.transfer;
    scene.mpm->stress_update = scheme.update;
    return scene;
  }

  // Largest distance, and difference of stress, of any point of the part from the same point of the
  // whole.
  std::pair<double, double> furthest(const solid::Points &part, const solid::Points &whole)
  {
    double furthest = 0., stress = 0.;
    for (std::size_t p = 0; p < part.size(); ++p)
    {
      double least = std::numeric_limits<double>::max();
      std::size_t nearest = 0;
      for (std::size_t q = 0; q < whole.size(); ++q)
        if (const double d = std::hypot(part.x[p] - whole.x[q], part.y[p] - whole.y[q]); d < least)
          least = d, nearest = q;
      furthest = std::max(furthest, least);
      for (const auto &component :
           {&solid::Points::sxx, &solid::Points::syy, &solid::Points::szz, &solid::Points::sxy})
        stress = std::max(stress, std::abs((part.*component)[p] - (whole.*component)[nearest]));
    }
    return {furthest, stress};
  }
} // namespace

TEST_P(Mirrors, AQuarterDoesWhatItDoesInTheWhole)
{
  const solid::Owner whole =
      solid::make_solid(crossed_bars(GetParam(), {-4., -4.}, {8., 8.}, {32, 32}));
  scene::Scene scene = crossed_bars(GetParam(), {0., -4.}, {4., 4.}, {16, 16});
  cut(scene, scene::Edge::left), cut(scene, scene::Edge::top);
  const solid::Owner quarter = solid::make_solid(scene);
  ASSERT_EQ(solid::points(*whole), 4 * solid::points(*quarter));
  for (int k = 0; k < 10; ++k)
  {
    solid::advance(*whole, 0.02), solid::advance(*quarter, 0.02);
    const auto [distance, stress] = furthest(quarter->points, whole->points);
    ASSERT_LT(distance, 1e-11) << k;
    ASSERT_LT(stress, 1e-8) << k;
  }
}

using scene::ShapeFunction, scene::Transfer, scene::StressUpdate;
INSTANTIATE_TEST_SUITE_P(
    Schemes, Mirrors,
    testing::Values(Scheme{ShapeFunction::quadratic_bspline, Transfer::tpic, StressUpdate::last},
                    Scheme{ShapeFunction::quadratic_bspline, Transfer::apic, StressUpdate::last},
                    Scheme{ShapeFunction::quadratic_bspline, Transfer::xpic2, StressUpdate::last},
                    Scheme{ShapeFunction::ugimp, Transfer::flip, StressUpdate::first},
                    Scheme{ShapeFunction::linear, Transfer::pic, StressUpdate::first}));

// Loads, supports and reactions next to the side: a block pressed down, its foot held.
TEST(MirrorSides, HalfABlockBearsHalfTheLoad)
{
  const auto make = [](const double left)
  {
    scene::Scene scene = small::rectangle({-1., 0.5}, {2., 2.}, {2. - left, 4.},
                                          {static_cast<int>(8. * (2. - left)), 32});
    scene.domain.lower = {left, 0.};
    small::hold(scene, "foot", scene::Edge::bottom, "0", "0");
    scene::Traction load;
    load.name = "press", load.where = scene::Edge::top;
    load.traction = {small::text("0"), small::text("-40*ramp(t, 0.1)")};
    scene.tractions.push_back(load);
    if (left == 0.)
      cut(scene, scene::Edge::left);
    return solid::make_solid(scene);
  };
  const solid::Owner whole = make(-2.), half = make(0.);
  ASSERT_EQ(solid::points(*whole), 2 * solid::points(*half));
  for (int k = 0; k < 10; ++k)
  {
    solid::advance(*whole, 0.02), solid::advance(*half, 0.02);
    const auto [distance, stress] = furthest(half->points, whole->points);
    ASSERT_LT(distance, 1e-11) << k;
    ASSERT_LT(stress, 1e-8) << k;
    const double of_half = solid::reaction(*half, "foot").force[1],
                 of_whole = solid::reaction(*whole, "foot").force[1];
    ASSERT_NEAR(2. * of_half, of_whole, 1e-9 * std::abs(of_whole)) << k;
  }
}
