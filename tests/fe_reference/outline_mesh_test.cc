// Meshes keep to the outlines that they are made of: straight parts exactly, curves to second
// order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fe_reference/mesh.h"
#include "scene/geometry.h"
#include "scene/reader.h"
#include "small_scenes.h"

namespace
{
  scene::Body body(const scene::Polyline &outline)
  {
    scene::Body result;
    result.shape = scene::Polygon{{outline}};
    return result;
  }

  // A block 2 x 1 with its upper corners rounded by chords.
  scene::Polyline filleted_block(const double radius, const int chords)
  {
    scene::Polyline line{{0., 0.}, {2., 0.}};
    for (const double x : {2. - radius, radius})
      for (int k = 0; k <= chords; ++k)
      {
        const double angle = 0.5 * M_PI * (k / double(chords) + (x < 1. ? 1. : 0.));
        line.emplace_back(x + radius * std::cos(angle), 1. - radius + radius * std::sin(angle));
      }
    return line;
  }

  // Length of the mesh's sides on the line y = 1.
  double length_on_top(const fe::QuadMesh &mesh)
  {
    double length = 0.;
    for (const auto &cell : mesh.cells)
      for (int k = 0; k < 4; ++k)
      {
        const fe::Point &a = mesh.vertices[cell[k]], &b = mesh.vertices[cell[(k + 1) % 4]];
        if (std::abs(a[1] - 1.) < 1e-9 && std::abs(b[1] - 1.) < 1e-9)
          length += std::abs(b[0] - a[0]);
      }
    return length;
  }

  scene::Scene block_on_its_base(const scene::Polyline &outline, const std::array<int, 2> &cells)
  {
    scene::Scene scene = fe_test::solid_scene(1e6, cells, 2, 1);
    scene.domain.lower = {-1., -0.5}, scene.domain.size = {4., 2.}, scene.domain.cells = {80, 40};
    scene.bodies = {body(outline)};
    scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "0", "0")};
    return scene;
  }
} // namespace

TEST(OutlineMesh, KeepsAStraightEdgeUpToTheFilletsBesideIt)
{
  for (const double radius : {0.1, 0.2, 0.3})
    for (const int cells : {10, 20, 40})
    {
      const scene::Scene scene = block_on_its_base(filleted_block(radius, 16), {2 * cells, cells});
      const fe::QuadMesh mesh = fe::make_mesh(scene);
      EXPECT_NEAR(length_on_top(mesh), 2. - 2. * radius, 1e-9) << radius << ' ' << cells;
      EXPECT_NEAR(fe::filled_fraction(scene, mesh), 1., 1e-3) << radius << ' ' << cells;
    }
}

TEST(OutlineMesh, KeepsChamfersSmallerThanItsCells)
{
  const scene::Scene scene = block_on_its_base(
      {{0., 0.}, {2., 0.}, {2., 0.98}, {1.98, 1.}, {0.02, 1.}, {0., 0.98}}, {20, 10});
  const fe::QuadMesh mesh = fe::make_mesh(scene);
  EXPECT_NEAR(length_on_top(mesh), 1.96, 1e-9);
  EXPECT_NEAR(fe::filled_fraction(scene, mesh), 1., 1e-9);
}

// An end of a load on a fillet, where the outline is curved, is a vertex too.
TEST(OutlineMesh, HasVerticesWhereALoadedBoxCutsACurve)
{
  scene::Scene scene = block_on_its_base(filleted_block(0.3, 64), {20, 10});
  scene::Traction load;
  load.where = scene::Box{{1.8, 0.5}, {3., 2.}};
  scene.tractions = {load};
  const double y = 0.7 + std::sqrt(0.09 - 0.01);
  const fe::QuadMesh mesh = fe::make_mesh(scene);
  EXPECT_TRUE(std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                          [&](const fe::Point &v)
                          { return std::abs(v[0] - 1.8) < 1e-9 && std::abs(v[1] - y) < 1e-4; }));
}

// The outline of a disc is a chord of at most a tenth of a cell off it, the mesh's vertices too.
TEST(OutlineMesh, HasItsVerticesOnTheCircle)
{
  const double radius = 0.5;
  scene::Body disc;
  disc.shape = scene::Disc{{1., 2.}, radius};
  for (const double size : {0.1, 0.03, 0.01})
  {
    const fe::QuadMesh mesh = fe::mesh_outline({disc}, {}, {size, size});
    std::map<std::array<int, 2>, int> sides;
    for (const auto &cell : mesh.cells)
      for (int k = 0; k < 4; ++k)
        ++sides[{std::min(cell[k], cell[(k + 1) % 4]), std::max(cell[k], cell[(k + 1) % 4])}];
    double farthest = 0.;
    for (const auto &[side, cells] : sides)
      for (const int vertex : side)
        if (cells == 1)
          farthest = std::max(
              farthest, std::abs((mesh.vertices[vertex] - fe::Point(1., 2.)).norm() - radius));
    EXPECT_LT(farthest, 1.01 * std::pow(0.1 * size, 2) / (8. * radius)) << size;
  }
}

namespace
{
  // The mesh of a block 2 x 1 whose side at `y` dips by `dip` at its right end.
  fe::Discretisation dipping(const scene::Scene &scene, const double y, const double dip)
  {
    fe::QuadMesh mesh = fe::make_mesh(scene);
    for (fe::Point &p : mesh.vertices)
      if (p[1] == y)
        p[1] -= 0.5 * p[0] * dip;
    return fe::discretise(mesh, 2);
  }
} // namespace

TEST(OutlineLengths, RefuseAMeshThatLeavesAHeldEdge)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 4}, 2, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "0", "0"),
                    fe_test::support("top", scene::Edge::top, "0", "-0.1*t")};
  EXPECT_NO_THROW(fe::make_supports(scene, dipping(scene, 1., 0.)));
  EXPECT_THROW(fe::make_supports(scene, dipping(scene, 1., 1e-4)), scene::BadScene);
}

TEST(OutlineLengths, RefuseAMeshThatLeavesALoadedEdge)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 4}, 2, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "0", "0")};
  scene::Traction load;
  load.where = scene::Edge::top;
  load.traction = {fe_test::expression("0"), fe_test::expression("1")};
  scene.tractions = {load};
  EXPECT_NO_THROW(fe::make_loads(scene, dipping(scene, 1., 0.)));
  EXPECT_THROW(fe::make_loads(scene, dipping(scene, 1., 1e-4)), scene::BadScene);
}

TEST(OutlineLengths, RefuseAMeshThatLeavesASymmetrySide)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 4}, 2, 1);
  scene.domain.size = {4., 2.}, scene.domain.cells = {16, 8};
  scene.domain.boundary[2] = scene::Boundary::symmetry;
  scene.bodies = {fe_test::rectangle(0., 0., 2., 1.)};
  scene.supports = {fe_test::support("top", scene::Edge::top, "0", "-0.1*t")};
  EXPECT_NO_THROW(fe::make_supports(scene, dipping(scene, 0., 0.)));
  EXPECT_THROW(fe::make_supports(scene, dipping(scene, 0., 1e-4)), scene::BadScene);
}
