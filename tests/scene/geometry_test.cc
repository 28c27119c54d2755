// Distances against the distance to a finely sampled outline, areas against formulas.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "scene/geometry.h"
#include "scene/reader.h"

using scene::Body;
using scene::Point;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  template <class Shape>
  Body body(const Shape &shape)
  {
    Body result;
    result.shape = shape;
    return result;
  }

  std::vector<Body> all_shapes()
  {
    return {body(scene::Rectangle{{0.1, -0.3}, {1.2, 0.7}}), body(scene::Disc{{0.2, 0.1}, 0.6}),
            body(scene::Ring{{0.2, 0.1}, 0.3, 0.8}),
            // A dart (not convex) with a triangular hole.
            body(scene::Polygon{{{{-1., -1.}, {1., -1.}, {0.8, 1.}, {0., 0.4}, {-1., 1.}},
                                 {{-0.5, -0.6}, {0.5, -0.6}, {0., 0.}}}})};
  }

  double distance_by_sampling(const Body &b, const Point &p, const double spacing)
  {
    double nearest = 1e300;
    for (const auto &line : scene::outline({b}, spacing))
      for (const Point &q : line)
        nearest = std::min(nearest, (p - q).norm());
    return nearest;
  }

  double area(const std::vector<scene::Polyline> &lines)
  {
    double sum = 0.;
    for (const auto &line : lines)
      sum += scene::signed_area(line);
    return sum;
  }
} // namespace

// A sample on the outline is at most half a spacing from the nearest outline point, so the sampled
// distance lies between d and sqrt(d^2 + (spacing/2)^2) (plus the sagitta of a subdivided circle).
TEST(SignedDistance, AgreesWithASampledOutline)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  constexpr double spacing = 2e-3;
  for (const Body &b : all_shapes())
    for (int i = 0; i < 60; ++i)
    {
      const Point p(uniform(generator), uniform(generator));
      const double exact = std::abs(scene::signed_distance(b, p));
      const double sampled = distance_by_sampling(b, p, spacing);
      EXPECT_GE(sampled, exact - 1e-12);
      EXPECT_LE(sampled, std::hypot(exact, spacing / 2.) + 1e-5);
    }
}

TEST(SignedDistance, IsPositiveInside)
{
  const auto shapes = all_shapes();
  EXPECT_GT(scene::signed_distance(shapes[0], {0.7, 0.}), 0.);
  EXPECT_LT(scene::signed_distance(shapes[0], {1.4, 0.}), 0.);
  EXPECT_DOUBLE_EQ(scene::signed_distance(shapes[1], {0.2, 0.1}), 0.6);
  EXPECT_DOUBLE_EQ(scene::signed_distance(shapes[2], {0.2, 0.1}), -0.3);
  EXPECT_GT(scene::signed_distance(shapes[3], {-0.8, 0.}), 0.);
  EXPECT_LT(scene::signed_distance(shapes[3], {0., -0.4}), 0.); // in the hole
  EXPECT_LT(scene::signed_distance(shapes[3], {0., 0.9}), 0.);  // in the notch
}

TEST(SignedDistance, IsExactAtACornerOfARectangle)
{
  const Body b = body(scene::Rectangle{{0., 0.}, {2., 1.}});
  EXPECT_DOUBLE_EQ(scene::signed_distance(b, {5., 5.}), -5.); // 3-4-5 from the corner
  EXPECT_DOUBLE_EQ(scene::signed_distance(b, {0.25, 0.5}), 0.25);
}

TEST(SignedDistance, OfAUnionIsTheLargest)
{
  const Body a = body(scene::Disc{{0., 0.}, 1.}), b = body(scene::Disc{{3., 0.}, 1.});
  EXPECT_DOUBLE_EQ(scene::signed_distance({a, b}, {1.5, 0.}), -0.5);
  EXPECT_DOUBLE_EQ(scene::signed_distance({a, b}, {3., 0.}), 1.);
}

TEST(SignedDistance, RefusesARecordedOutline)
{
  EXPECT_THROW(scene::signed_distance(body(scene::RecordedOutline{"a.h5", "contour", -1., {}, {}}),
                                      {0., 0.}),
               scene::BadScene);
}

TEST(BoundingBox, HoldsAllBodiesTightly)
{
  const scene::Box box = scene::bounding_box(all_shapes());
  EXPECT_DOUBLE_EQ(box.lower[0], -1.);
  EXPECT_DOUBLE_EQ(box.lower[1], -1.);
  EXPECT_DOUBLE_EQ(box.upper[0], 1.3);
  EXPECT_DOUBLE_EQ(box.upper[1], 1.);
}

TEST(Outline, HasTheAreaOfTheShape)
{
  const auto shapes = all_shapes();
  EXPECT_NEAR(area(scene::outline({shapes[0]}, 0.05)), 0.84, 1e-12);
  // A regular n-gon in a circle: area n/2 sin(2 pi/n) r^2, with n = 4 ceil(2 pi r/(4 spacing)).
  const double n = 4. * std::ceil(2. * pi * 0.6 / 0.05 / 4.);
  EXPECT_NEAR(area(scene::outline({shapes[1]}, 0.05)), n / 2. * std::sin(2. * pi / n) * 0.36,
              1e-12);
  EXPECT_NEAR(area(scene::outline({shapes[2]}, 1e-3)), pi * (0.64 - 0.09), 1e-5);
  // Dart: the quadrilateral minus the notch minus the hole, by the shoelace formula.
  EXPECT_NEAR(area(scene::outline({shapes[3]}, 0.05)), 3.26 - 0.3, 1e-9);
}

// Boost.Geometry compares coordinates absolutely: in metres a body of nanometres was no body.
TEST(Outline, IsTheSameInAnyUnitOfLength)
{
  for (const double unit : {1e-9, 1e6})
  {
    const std::vector<scene::Body> dogbone{
        body(scene::Rectangle{{0., 0.}, unit * scene::Point(3., 1.)}),
        body(scene::Rectangle{unit * scene::Point(1., 1.), unit * scene::Point(1., 2.)}),
        body(scene::Rectangle{unit * scene::Point(0., 3.), unit * scene::Point(3., 1.)})};
    const auto lines = scene::outline(dogbone, 0.5 * unit);
    ASSERT_EQ(lines.size(), 1u) << unit;
    EXPECT_NEAR(area(lines) / (unit * unit), 8., 1e-9) << unit;
    scene::Polyline square{{0., 0.}, {unit, 0.}, {unit, unit}, {0., unit}}, bow = square;
    std::swap(bow[0], bow[1]);
    EXPECT_FALSE(scene::crosses_itself(square)) << unit;
    EXPECT_TRUE(scene::crosses_itself(bow)) << unit;
    const scene::Polyline beside{
        {0.5 * unit, 0.}, {1.5 * unit, 0.}, {1.5 * unit, unit}, {0.5 * unit, unit}};
    EXPECT_NEAR(scene::shared_area(square, beside) / (unit * unit), 0.5, 1e-7) << unit;
  }
}

TEST(Outline, SpacesItsVerticesAsAsked)
{
  for (const Body &b : all_shapes())
    for (const auto &line : scene::outline({b}, 0.05))
      for (std::size_t i = 0; i < line.size(); ++i)
      {
        const double step = (line[(i + 1) % line.size()] - line[i]).norm();
        EXPECT_LE(step, 0.05 * (1. + 1e-9));
        EXPECT_GT(step, 0.);
      }
}

TEST(Outline, OfTouchingRectanglesIsOneDogbone)
{
  const std::vector<Body> dogbone{body(scene::Rectangle{{0., 0.}, {4., 1.}}),
                                  body(scene::Rectangle{{1., 1.}, {2., 5.}}),
                                  body(scene::Rectangle{{0., 6.}, {4., 1.}})};
  const auto lines = scene::outline(dogbone, 0.5);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(area(lines), 4. + 10. + 4., 1e-9);
}

TEST(Outline, OfOverlappingDiscsHasTheAreaOfTheirUnion)
{
  // Two unit discs a distance 1 apart: 2 pi - (2 pi/3 - sqrt(3)/2).
  const std::vector<Body> discs{body(scene::Disc{{0., 0.}, 1.}), body(scene::Disc{{1., 0.}, 1.})};
  EXPECT_NEAR(area(scene::outline(discs, 2e-3)), 2. * pi - (2. * pi / 3. - std::sqrt(3.) / 2.),
              1e-5);
}

TEST(Outline, IsCutAtTheSymmetrySidesOfTheDomain)
{
  scene::Domain domain;
  domain.size = {2., 2.};
  domain.cells = {20, 20};
  domain.boundary = {scene::Boundary::symmetry, scene::Boundary::no_flux, scene::Boundary::symmetry,
                     scene::Boundary::no_flux};
  const Body ring = body(scene::Ring{{0., 0.}, 0.5, 1.});
  const auto lines = scene::outline({ring}, domain, 1e-3);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(area(lines), pi / 4. * (1. - 0.25), 1e-5);
  for (const Point &p : lines.front())
    EXPECT_TRUE(p[0] >= 0. && p[1] >= 0.);
  // Without symmetry sides, or away from them, nothing changes.
  domain.boundary = {};
  EXPECT_NEAR(area(scene::outline({ring}, domain, 1e-3)), pi * (1. - 0.25), 1e-5);
}

TEST(Outline, OfSeparateBodiesHasOneLineEach)
{
  EXPECT_EQ(scene::outline({body(scene::Disc{{0., 0.}, 1.}), body(scene::Disc{{3., 0.}, 1.})}, 0.1)
                .size(),
            2u);
}

TEST(SignedArea, KeepsItsDigitsFarFromTheOrigin)
{
  const Point far(1e8, -1e8);
  EXPECT_DOUBLE_EQ(scene::signed_area({far, far + Point(1., 0.), far + Point(0., 1.)}), 0.5);
  EXPECT_DOUBLE_EQ(scene::signed_area({far, far + Point(0., 1.), far + Point(1., 0.)}), -0.5);
}

TEST(Contains, FindsSidesSegmentsAndRegions)
{
  const scene::Box box{{0., 0.}, {2., 1.}};
  EXPECT_TRUE(scene::contains(scene::Edge::top, box, {0.5, 1.}, 1e-9));
  EXPECT_FALSE(scene::contains(scene::Edge::top, box, {0.5, 0.9}, 1e-9));
  EXPECT_TRUE(scene::contains(scene::Edge::left, box, {0., 0.9}, 1e-9));
  EXPECT_TRUE(scene::contains(scene::Edge::right, box, {2., 0.9}, 1e-9));
  EXPECT_TRUE(scene::contains(scene::Edge::bottom, box, {1., 0.}, 1e-9));
  const scene::Segment segment{{0., 0.}, {1., 0.}};
  EXPECT_TRUE(scene::contains(segment, box, {0.5, 0.05}, 0.1));
  EXPECT_FALSE(scene::contains(segment, box, {1.2, 0.}, 0.1)) << "past its end";
  EXPECT_TRUE(scene::contains(scene::Box{{0., 0.}, {1., 1.}}, box, {0.5, 0.5}, 1e-9));
  EXPECT_FALSE(scene::contains(scene::Box{{0., 0.}, {1., 1.}}, box, {1.5, 0.5}, 1e-9));
}
