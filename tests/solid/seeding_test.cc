// Bodies that lie askew to the lattice of points: nothing of them may be lost or moved.
#include <gtest/gtest.h>

#include <cmath>

#include "small_scenes.h"

namespace
{
  using scene::Point;
  using Shape = decltype(scene::Body::shape);
  constexpr double pi = 3.14159265358979323846;

  struct Moments
  {
    double area;
    Point centre;
    double polar; // about the origin, per area
  };

  scene::Scene scene_of(const std::vector<Shape> &shapes, const int cells)
  {
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, {2., 2.}, {cells, cells});
    scene.bodies.clear();
    for (const auto &shape : shapes)
    {
      scene::Body body;
      body.name = "body " + std::to_string(scene.bodies.size());
      body.shape = shape;
      scene.bodies.push_back(body);
    }
    return scene;
  }

  // With a velocity field as weight, momentum is its integral over the points' masses.
  Point integral(scene::Scene scene, const std::string &x, const std::string &y)
  {
    for (scene::Body &body : scene.bodies)
      body.velocity = {small::text(x), small::text(y)};
    const solid::Owner solid = solid::make_solid(scene);
    const solid::History history = solid::history(*solid);
    return {small::value_of(history, "momentum_x"), small::value_of(history, "momentum_y")};
  }

  void expect(const std::vector<Shape> &shapes, const Moments &exact)
  {
    const int cells = 20;
    const scene::Scene scene = scene_of(shapes, cells);
    const Point zeroth = integral(scene, "1", "x*x + y*y"), first = integral(scene, "x", "y");
    const double cell = 2. / cells;
    EXPECT_NEAR(zeroth[0] / exact.area, 1., 1e-3);
    EXPECT_NEAR((first / zeroth[0] - exact.centre).norm(), 0., 1e-3 * cell);
    // Points have no extent: a lattice of spacing h in a square misses h^2/12 of each axis.
    const double missed = 2. * std::pow(0.5 * cell, 2) / 12.;
    EXPECT_NEAR(zeroth[1] / zeroth[0] + missed, exact.polar, 1.5e-3 * exact.polar);
  }
} // namespace

TEST(Seeding, OfAPolygonThatStandsOblique)
{
  const double angle = 0.3, length = 1.1, height = 0.47;
  const Point along(std::cos(angle), std::sin(angle)), up(-along[1], along[0]);
  const Point corner(0.513, 0.307);
  const scene::Polygon polygon{{{corner, corner + length * along,
                                 corner + length * along + height * up, corner + height * up}}};
  const Point centre = corner + 0.5 * (length * along + height * up);
  expect({polygon}, {length * height, centre,
                     centre.squaredNorm() + (length * length + height * height) / 12.});
}

TEST(Seeding, OfADisc)
{
  const Point centre(0.913, 1.047);
  expect({scene::Disc{centre, 0.631}},
         {pi * 0.631 * 0.631, centre, centre.squaredNorm() + 0.5 * 0.631 * 0.631});
}

TEST(Seeding, OfAUnionWhosePartsOverlap)
{
  // A cross: two bars of 1.2 x 0.31, of which the middle counts once.
  const Point centre(1.013, 0.987);
  const double a = 1.2, b = 0.31;
  const double area = 2. * a * b - b * b;
  const double polar = (2. * a * b * (a * a + b * b) - b * b * 2. * b * b) / 12. / area;
  expect({scene::Rectangle{centre - 0.5 * Point(a, b), {a, b}},
          scene::Rectangle{centre - 0.5 * Point(b, a), {b, a}}},
         {area, centre, centre.squaredNorm() + polar});
}

TEST(Seeding, LeavesTheWeightOfABlockWhereItIs)
{
  // A polygon whose rows are cut by the lattice, between sides that slip, under its weight:
  // sigma_yy = -rho g (h - y) at every point, the cut rows included.
  for (const double bottom : {0.13, 0.145})
  {
    const double h = 2., E = 1e4;
    scene::Scene scene = small::rectangle({0., 0.}, {1., 1.}, {1., 2.5}, {10, 25});
    scene.bodies[0].shape =
        scene::Polygon{{{{-0.5, bottom}, {1.5, bottom}, {1.5, bottom + h}, {-0.5, bottom + h}}}};
    scene.domain.boundary = {scene::Boundary::symmetry, scene::Boundary::symmetry,
                             scene::Boundary::no_flux, scene::Boundary::no_flux};
    scene.solid->young_modulus = E;
    scene.body_force = scene::BodyForce{{small::text("0"), small::text("-smooth(t, 1)")}, {}};
    small::hold(scene, "bottom", scene::Edge::bottom, std::nullopt, "0");
    const solid::Owner solid = solid::make_solid(scene);
    solid::advance(*solid, 1.2);
    const record::Snapshot points = solid::snapshot(*solid, {"stress_yy"});
    const auto &Y = points.fields.at("initial_y"), &stress = points.fields.at("stress_yy");
    double worst = 0.;
    for (std::size_t p = 0; p < Y.size(); ++p)
      worst = std::max(worst, std::abs(stress[p] + (h - (Y[p] - bottom))));
    EXPECT_LE(worst, 0.01 * h) << "bottom at " << bottom;
  }
}

// The seam of two bodies that touch is no outline: nothing is missing along it.
TEST(Seeding, OfBodiesThatTouchLeavesNothingOutAtTheirSeam)
{
  for (const double shift : {0.013, 0.031, 0.047})
  {
    const double x = 0.4 + shift;
    const std::vector<Shape> pair{scene::Rectangle{{0.3, 0.3}, {x - 0.3, 0.8}},
                                  scene::Rectangle{{x, 0.3}, {0.7, 0.8}}};
    const Point zeroth = integral(scene_of(pair, 20), "1", "1");
    EXPECT_NEAR(zeroth[0], (x + 0.4) * 0.8, 1e-9) << shift;
  }
  const std::vector<Shape> plugged{scene::Ring{{1.01, 0.98}, 0.3, 0.7},
                                   scene::Disc{{1.01, 0.98}, 0.3}};
  EXPECT_NEAR(integral(scene_of(plugged, 20), "1", "1")[0], pi * 0.49, 3e-4);
}

// Half of a bar whose symmetry line no lattice of points follows from its other end.
TEST(Seeding, OfARectangleThatASymmetrySideCuts)
{
  scene::Scene scene = small::rectangle({-0.47, -1.}, {0.94, 2.}, {1., 2.}, {10, 20});
  scene.domain.boundary[static_cast<int>(scene::Edge::left)] = scene::Boundary::symmetry;
  scene.domain.boundary[static_cast<int>(scene::Edge::bottom)] = scene::Boundary::symmetry;
  for (const int per_cell : {2, 3})
  {
    scene.mpm->points_per_cell = {per_cell, per_cell};
    const Point zeroth = integral(scene, "1", "1"), first = integral(scene, "x", "y");
    EXPECT_NEAR(zeroth[0], 0.47, 1e-9);
    EXPECT_NEAR(first[0] / zeroth[0], 0.235, 1e-9);
    EXPECT_NEAR(first[1] / zeroth[0], 0.5, 1e-9);
  }
}
