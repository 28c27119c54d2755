// Distances to interfaces of bodies that touch the domain's sides or each other.
#include "scene/interface_distance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "body.h"

using scene::Body;
using scene::Boundary;
using scene::Domain;
using scene::InterfaceDistance;
using scene::Point;
using scene_test::body;

namespace
{
  Domain box(const Boundary left_right = Boundary::no_flux)
  {
    Domain domain;
    domain.lower = {0., 0.}, domain.size = {10., 4.}, domain.cells = {100, 40};
    domain.boundary = {left_right, left_right, Boundary::no_flux, Boundary::no_flux};
    return domain;
  }
} // namespace

// A layer that fills the left 3 of the domain has one interface, x = 3: the distance is 3 - x.
TEST(InterfaceDistance, OfALayerSeesItsOneInterface)
{
  const std::vector<Body> shapes{body(scene::Rectangle{{0., 0.}, {3., 4.}}),
                                 body(scene::Polygon{{{{0., 0.}, {3., 0.}, {3., 4.}, {0., 4.}}}})};
  for (const Body &layer : shapes)
  {
    const InterfaceDistance distance({layer}, box(), 100., 0.1);
    for (const double x : {0., 0.7, 2.9, 3., 5., 10.})
      for (const double y : {0., 1.3, 4.})
        EXPECT_NEAR(distance({x, y}), 3. - x, 1e-12) << x << ", " << y;
  }
}

TEST(InterfaceDistance, OfABlockInACornerSeesTwoEdges)
{
  const InterfaceDistance distance({body(scene::Rectangle{{7., 0.}, {3., 2.}})}, box(), 100., 0.1);
  EXPECT_NEAR(distance({10., 0.}), 2., 1e-12);
  EXPECT_NEAR(distance({7.5, 0.}), 0.5, 1e-12);
  EXPECT_NEAR(distance({10., 3.}), -1., 1e-12);
  EXPECT_NEAR(distance({4., 6.}), -5., 1e-12);
}

// However far a body reaches over a symmetry side, it is the same crystal.
TEST(InterfaceDistance, DoesNotSeeWhatReachesOverASymmetrySide)
{
  const Domain domain = box(Boundary::symmetry);
  for (const double over : {1e-3, 0.05, 1., 20.})
    for (const Body &layer :
         {body(scene::Rectangle{{-over, 0.}, {3. + over, 4.}}),
          body(scene::Polygon{{{{-over, 0.}, {3., 0.}, {3., 4.}, {-over, 4.}}}})})
    {
      const InterfaceDistance distance({layer}, domain, 100., 0.1);
      for (const double x : {0., 0.7, 3., 5.})
        EXPECT_NEAR(distance({x, 1.3}), 3. - x, 1e-9) << over << ", " << x;
    }
}

// Two circles grown together, mirrored in the right side: the nearest interface is the neck's edge.
TEST(InterfaceDistance, OfADiscCutByASymmetrySideIsToTheNeck)
{
  const Domain domain = box(Boundary::symmetry);
  const InterfaceDistance cut({body(scene::Disc{{9.1, 2.}, 1.})}, domain, 100., 1e-3);
  EXPECT_NEAR(cut({10., 2.}), std::sqrt(1. - 0.81), 1e-5);
  EXPECT_NEAR(cut({9.1, 2.}), 1., 1e-5);
  const InterfaceDistance half({body(scene::Disc{{10., 2.}, 1.})}, domain, 100., 0.5);
  EXPECT_NEAR(half({9.6, 2.}), 0.6, 1e-14) << "a circle about a point of the side stays a circle";
}

TEST(InterfaceDistance, OfABodyThatFillsTheDomainIsFar)
{
  const InterfaceDistance distance({body(scene::Rectangle{{0., 0.}, {10., 4.}})}, box(), 1., 0.1);
  for (const Point &p : {Point(0., 0.), Point(5., 2.), Point(10., 4.)})
    EXPECT_GT(distance(p), 50.);
}

// Behind a periodic side is the far end of the domain: melt, unless the body reaches there too.
TEST(InterfaceDistance, KeepsThePeriodicSideOfABodyThatEndsThere)
{
  const Domain periodic = box(Boundary::periodic);
  const InterfaceDistance half({body(scene::Rectangle{{0., 0.}, {3., 4.}})}, periodic, 100., 0.1);
  EXPECT_NEAR(half({0.5, 2.}), 0.5, 1e-12);
  const InterfaceDistance band({body(scene::Rectangle{{0., 0.}, {10., 2.}})}, periodic, 100., 0.1);
  EXPECT_NEAR(band({0., 0.5}), 1.5, 1e-12);
}

// An L of two rectangles: inside, the nearest interface is the re-entrant corner or an outer edge.
TEST(InterfaceDistance, HasNoSeamBetweenTouchingBodies)
{
  const std::vector<Body> bodies{body(scene::Rectangle{{1., 1.}, {0.1 + 0.2, 2.}}),
                                 body(scene::Rectangle{{1.3, 1.}, {2.7, 1.}})};
  const InterfaceDistance distance(bodies, box(), 100., 0.1);
  EXPECT_NEAR(distance({1.3, 1.1}), 0.1, 1e-9);
  EXPECT_NEAR(distance({1.3, 1.9}), 0.1, 1e-9);
  EXPECT_NEAR(distance({1.2, 1.5}), 0.2, 1e-9);
  EXPECT_NEAR(distance({1.3, 2.5}), 0., 1e-9);
  EXPECT_NEAR(distance({2., 2.5}), -0.5, 1e-9);
}

// Two overlapping discs: on the chord between the crossing points these are nearest.
TEST(InterfaceDistance, OfOverlappingDiscsIsThatOfTheirUnion)
{
  const std::vector<Body> bodies{body(scene::Disc{{4., 2.}, 1.}), body(scene::Disc{{5.2, 2.}, 1.})};
  const InterfaceDistance distance(bodies, box(), 100., 0.01);
  EXPECT_NEAR(distance({4.6, 2.}), 0.8, 1e-3);
  EXPECT_NEAR(distance({3.5, 2.}), 0.5, 1e-3);
  EXPECT_NEAR(distance({4.6, 3.}), -(std::hypot(0.6, 1.) - 1.), 1e-12);
}
