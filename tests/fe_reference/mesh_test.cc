// Meshes of the shapes that scenes know.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fe_reference/mesh.h"
#include "scene/reader.h"
#include "small_scenes.h"

namespace
{
  double area_of(const fe::QuadMesh &mesh)
  {
    double area = 0.;
    for (const auto &cell : mesh.cells)
      for (int k = 0; k < 4; ++k)
      {
        const fe::Point &a = mesh.vertices[cell[k]], &b = mesh.vertices[cell[(k + 1) % 4]];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
    return area;
  }

  double smallest_corner(const fe::QuadMesh &mesh)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto &cell : mesh.cells)
      for (int k = 0; k < 4; ++k)
      {
        const fe::Point a = mesh.vertices[cell[(k + 1) % 4]] - mesh.vertices[cell[k]],
                        b = mesh.vertices[cell[(k + 3) % 4]] - mesh.vertices[cell[k]];
        smallest = std::min(smallest, a[0] * b[1] - a[1] * b[0]);
      }
    return smallest;
  }

  scene::Body disc(const double radius)
  {
    scene::Body body;
    body.shape = scene::Disc{{1., 2.}, radius};
    return body;
  }
} // namespace

TEST(RectangleMesh, FillsTheDogboneWithThePapersCells)
{
  // Grips 4 x 1, gauge 2 x 5, cells of 0.5: 16 + 40 + 16.
  const std::vector<scene::Body> dogbone{fe_test::rectangle(0., 0., 4., 1.),
                                         fe_test::rectangle(1., 1., 2., 5.),
                                         fe_test::rectangle(0., 6., 4., 1.)};
  const fe::QuadMesh mesh = fe::mesh_rectangles(dogbone, {8, 14}, 0., {});
  EXPECT_EQ(mesh.cells.size(), 72u);
  EXPECT_NEAR(area_of(mesh), 18., 1e-12);
}

TEST(RectangleMesh, OverlappingRectanglesAreMeshedOnce)
{
  const fe::QuadMesh mesh = fe::mesh_rectangles(
      {fe_test::rectangle(0., 0., 2., 1.), fe_test::rectangle(1., 0.5, 2., 1.)}, {6, 3}, 0., {});
  EXPECT_NEAR(area_of(mesh), 2. + 2. - 0.5, 1e-12);
}

TEST(RectangleMesh, GradingCrowdsLinesAtHeldCornersOnly)
{
  const std::vector<scene::Body> beam{fe_test::rectangle(0., 0., 8., 1.)};
  const fe::QuadMesh mesh = fe::mesh_rectangles(
      beam, {16, 4}, 0.5, {fe_test::support("root", scene::Edge::left, "0", "0")});
  double nearest = 8., last = 0.;
  for (const fe::Point &p : mesh.vertices)
  {
    if (p[0] > 0.)
      nearest = std::min(nearest, p[0]);
    if (p[0] < 8. - 1e-9)
      last = std::max(last, p[0]);
  }
  EXPECT_NEAR(nearest, 8. * std::pow(1. / 16., 2.), 1e-12); // s^(1/(1 - 0.5))
  EXPECT_NEAR(last, 8. * std::pow(15. / 16., 2.), 1e-12);
  EXPECT_NEAR(area_of(mesh), 8., 1e-12);
}

TEST(OutlineMesh, FillsADiscWithConvexQuadrilaterals)
{
  const fe::QuadMesh mesh = fe::mesh_outline({disc(0.5)}, {}, {0.05, 0.05});
  EXPECT_GT(mesh.cells.size(), 200u);
  EXPECT_GT(smallest_corner(mesh), 0.);
  EXPECT_NEAR(area_of(mesh), M_PI * 0.25, 0.01 * M_PI * 0.25);
}

TEST(OutlineMesh, LeavesTheHoleOfARingOpen)
{
  scene::Body ring;
  ring.shape = scene::Ring{{0., 0.}, 0.4, 1.};
  const fe::QuadMesh mesh = fe::mesh_outline({ring}, {}, {0.1, 0.1});
  EXPECT_GT(smallest_corner(mesh), 0.);
  EXPECT_NEAR(area_of(mesh), M_PI * (1. - 0.16), 0.02 * M_PI);
  for (const fe::Point &p : mesh.vertices)
    EXPECT_GT(p.norm(), 0.39);
}

TEST(OutlineMesh, KeepsTheCornersOnSymmetrySides)
{
  // Whatever the cell size: a ring's quarter that lost the corner at an axis would hang beside it.
  scene::Domain domain;
  domain.size = {2.4, 2.4};
  domain.cells = {24, 24};
  domain.boundary = {scene::Boundary::symmetry, scene::Boundary::no_flux, scene::Boundary::symmetry,
                     scene::Boundary::no_flux};
  scene::Body ring;
  ring.shape = scene::Ring{{0., 0.}, 1., 2.};
  for (const double size : {0.1, 0.13, 2. / 12., 0.2, 0.3})
  {
    const fe::QuadMesh mesh = fe::mesh_outline({ring}, domain, {size, size});
    for (const fe::Point &corner :
         {fe::Point(1., 0.), fe::Point(2., 0.), fe::Point(0., 1.), fe::Point(0., 2.)})
    {
      double nearest = 1.;
      for (const fe::Point &vertex : mesh.vertices)
        nearest = std::min(nearest, (vertex - corner).norm());
      EXPECT_LT(nearest, 1e-9) << size;
    }
  }
}

// No cell lies across an end of a support: on the outline there is a vertex, through the material
// runs a line.
TEST(Mesh, HasLinesWhereSupportsBeginAndEnd)
{
  for (const bool outline : {false, true})
  {
    scene::Scene scene = fe_test::solid_scene(1e6, {10, 5}, 2, 1);
    scene.domain.size = {4., 4.}, scene.domain.cells = {20, 20};
    scene.bodies = {fe_test::rectangle(1., 1., 2., 1.)};
    if (outline)
      scene.bodies[0].shape = scene::Polygon{{{{1., 1.}, {3., 1.}, {3., 2.}, {1., 2.}}}};
    scene.supports = {fe_test::support("segment", scene::Segment{{2.87, 2.}, {2.03, 2.}}, "0", ""),
                      fe_test::support("box", scene::Box{{0., 0.}, {1.53, 1.37}}, "0", "0")};
    const fe::QuadMesh mesh = fe::make_mesh(scene);
    EXPECT_NEAR(area_of(mesh), 2., 1e-9);
    for (const double end : {2.03, 2.87})
      EXPECT_TRUE(std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                              [&](const fe::Point &p)
                              { return (p - fe::Point(end, 2.)).norm() < 1e-9; }));
    for (const auto &cell : mesh.cells)
    {
      fe::Point middle = fe::Point::Zero();
      for (const int vertex : cell)
        middle += 0.25 * mesh.vertices[vertex];
      const bool held = middle[0] < 1.53 && middle[1] < 1.37;
      for (const int vertex : cell)
      {
        const fe::Point &p = mesh.vertices[vertex];
        const double out = std::max(p[0] - 1.53, p[1] - 1.37);
        EXPECT_TRUE(held ? out < 1e-9 : out > -1e-9) << p.transpose();
      }
    }
  }
}

TEST(Mesh, RefusesMaterialWithoutSupport)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {6, 2}, 1, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.), fe_test::rectangle(2., 0., 1., 1.)};
  scene.supports = {fe_test::support("left", scene::Edge::left, "0", "0")};
  EXPECT_THROW(fe::make_mesh(scene), scene::BadScene);
}

// Scenes with such outlines are refused when they are read; a record's outline is not looked at.
TEST(OutlineMesh, SaysWhatItCannotMesh)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {20, 20}, 1, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.bodies[0].shape = scene::Polygon{{{{0., 0.}, {1., 0.}, {0.1, 1.}, {1., 1.}}}};
  EXPECT_THROW(fe::make_mesh(scene), scene::BadScene);
}

TEST(Mesh, RefusesMoreThanTheMachineHolds)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {100000, 100000}, 1, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.supports = {fe_test::support("left", scene::Edge::left, "0", "0")};
  EXPECT_THROW(fe::make_mesh(scene), scene::BadScene);
}

namespace
{
  bool has_vertex(const fe::QuadMesh &mesh, const fe::Point &p)
  {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const fe::Point &v) { return (v - p).norm() < 1e-9; });
  }
} // namespace

// A load of length 0.334 must not become one of three whole sides.
TEST(Mesh, HasVerticesWhereALoadOrASupportEnds)
{
  scene::Scene scene;
  scene.domain.size = {4., 4.}, scene.domain.cells = {40, 40};
  scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "0", "0")};
  scene::Traction load;
  load.where = scene::Segment{{0.437, 1.}, {0.771, 1.}};
  scene.tractions = {load};
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  const fe::QuadMesh structured = fe::make_mesh(scene);
  scene::Body polygon;
  polygon.shape = scene::Polygon{{{{0., 0.}, {2.3, 0.}, {2., 1.}, {0., 1.}}}};
  scene.bodies = {polygon};
  const fe::QuadMesh unstructured = fe::make_mesh(scene);
  for (const double x : {0.437, 0.771})
  {
    EXPECT_TRUE(has_vertex(structured, {x, 1.})) << x;
    EXPECT_TRUE(has_vertex(unstructured, {x, 1.})) << x;
  }
  EXPECT_NEAR(area_of(unstructured), 2.15, 1e-9);
}
