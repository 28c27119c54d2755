#include <gtest/gtest.h>

#include <cmath>

#include "medium/area_map.h"
#include "medium/contour.h"

namespace
{
  using namespace medium;

  Mesh mesh_of(const int cells)
  {
    scene::Domain domain;
    domain.size = {2., 1.5}, domain.cells = {4 * cells, 3 * cells};
    return make_mesh(domain);
  }

  // A four-armed star, so that every case of marching squares comes up.
  Field<double> star(const Mesh &mesh, const double growth = 0.)
  {
    Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const Point x = mesh.position(i, j) - Point(0.93, 0.71);
        const double radius = 0.45 + growth + 0.15 * std::cos(4. * std::atan2(x[1], x[0]));
        phi(i, j) = std::tanh((radius - x.norm()) / 0.1);
      }
    fill_ghosts(phi, mesh);
    return phi;
  }
} // namespace

TEST(CellArea, AddsUpToWhatTheContourEncloses)
{
  const Mesh mesh = mesh_of(15);
  const Field<double> phi = star(mesh);
  EXPECT_NEAR(solid_area(phi, mesh), enclosed_area(contour(phi, mesh)), 1e-12);
}

TEST(CellArea, EndsAtTheTruePlaceOfAWall)
{
  const Mesh mesh = mesh_of(15);
  const Field<double> phi = star(mesh);
  const scene::Box active{{0.513, 0.2}, {2., 1.1137}};
  const double area = solid_area(phi, mesh, active);
  EXPECT_NEAR(area, enclosed_area(contour(phi, mesh, Profile::tanh_of_distance, active)), 1e-12);
  EXPECT_LT(area, 0.95 * solid_area(phi, mesh));
}

TEST(CellArea, ConvergesWithSecondOrder)
{
  const double pi = std::acos(-1.), exact = pi * (0.45 * 0.45 + 0.5 * 0.15 * 0.15);
  std::array<double, 3> error;
  for (int level = 0; level < 3; ++level)
    error[level] = std::abs(solid_area(star(mesh_of(15 << level)), mesh_of(15 << level)) - exact);
  EXPECT_GT(std::log2(error[0] / error[2]) / 2., 1.8);
}

TEST(CellArea, SharesItselfAmongSubCells)
{
  const Mesh mesh = mesh_of(15);
  const Field<double> phi = star(mesh);
  const CellAreas areas(phi, mesh);
  for (int j = 0; j < mesh.nodes[1] - 1; ++j)
    for (int i = 0; i < mesh.nodes[0] - 1; ++i)
    {
      const CellPart part = areas.part(i, j);
      const scene::Box cell = areas.box(i, j);
      double sum = 0.;
      for (int k = 0; k < part.pieces; ++k)
        for (int b = 0; b < 3; ++b)
          for (int a = 0; a < 2; ++a)
          {
            const Point third = (cell.upper - cell.lower).cwiseQuotient(Point(2., 3.));
            const Point lower = cell.lower + third.cwiseProduct(Point(a, b));
            sum += area(clip(part.piece[k], {lower, lower + third}));
          }
      ASSERT_NEAR(sum, part.area(), 1e-15);
      for (int k = 0; k < part.segments; ++k)
        ASSERT_LT(std::abs(areas.value(0.5 * (part.segment[k].a + part.segment[k].b))), 0.05);
    }
}

TEST(AreaMap, SaysWhatGrowthAddedAndWhere)
{
  const Mesh mesh = mesh_of(15);
  AreaMap map(mesh);
  map.measure(star(mesh), mesh, std::nullopt);
  const double before = map.total();
  const Field<double> grown = star(mesh, 0.01);
  double sum = 0.;
  long last = -1;
  for (const CellValue &change : map.change(grown, mesh, std::nullopt))
  {
    EXPECT_GT(change.cell, last);
    EXPECT_GT(change.value, 0.);
    sum += change.value, last = change.cell;
  }
  EXPECT_NEAR(before + sum, solid_area(grown, mesh), 1e-12);
  EXPECT_TRUE(map.change(grown, mesh, std::nullopt).empty());
  EXPECT_NEAR(map.total(), solid_area(grown, mesh), 1e-12);
}
