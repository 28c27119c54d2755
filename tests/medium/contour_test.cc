#include "medium/contour.h"

#include <cmath>

#include <gtest/gtest.h>

namespace medium
{
  namespace
  {
    Mesh square_mesh(int cells)
    {
      scene::Domain domain;
      domain.lower = {-1., -1.}, domain.size = {2., 2.}, domain.cells = {cells, cells};
      return make_mesh(domain);
    }

    template <class Function>
    Field<double> sampled(const Mesh &mesh, Function function)
    {
      Field<double> field(mesh);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          field(i, j) = function(mesh.position(i, j));
      fill_ghosts(field, mesh);
      return field;
    }

    double profile(double distance, double width)
    {
      return std::tanh(distance / (std::sqrt(2.) * width));
    }

    double largest_vertex_error(int cells)
    {
      const Point centre(0.013, -0.021);
      const auto phi = sampled(square_mesh(cells), [&](const Point &x)
                               { return profile(0.6 - (x - centre).norm(), 0.1); });
      double error = 0.;
      for (const Polyline &line : contour(phi, square_mesh(cells)))
        for (const Point &vertex : line)
          error = std::max(error, std::abs((vertex - centre).norm() - 0.6));
      return error;
    }
  } // namespace

  TEST(Contour, PlacesVerticesOnACircleToFourthOrder)
  {
    const double coarse = largest_vertex_error(40), fine = largest_vertex_error(80);
    EXPECT_LT(coarse, 1e-3 * 2. / 40);
    EXPECT_GT(std::log2(coarse / fine), 3.5);
  }

  TEST(Contour, EnclosesAStraightEdgedBodyExactly)
  {
    // The profile is straight, so the only error is rounding; corners are cut by at most half a
    // cell.
    const Mesh mesh = square_mesh(40);
    const auto strip = sampled(mesh, [](const Point &x) { return 0.333 - std::abs(x[0] + 0.1); });
    const auto lines = contour(strip, mesh, Profile::straight);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(enclosed_area(lines), 0.666 * 2., 1e-12);
    EXPECT_NEAR(interface_length(lines, extent(mesh)), 4., 1e-12);
  }

  TEST(Contour, WalksHolesClockwise)
  {
    const Mesh mesh = square_mesh(80);
    const auto ring =
        sampled(mesh, [](const Point &x) { return profile(0.2 - std::abs(x.norm() - 0.5), 0.05); });
    const auto lines = contour(ring, mesh);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_LT(enclosed_area({lines[0]}) * enclosed_area({lines[1]}), 0.);
    EXPECT_NEAR(enclosed_area(lines), M_PI * (0.49 - 0.09), 2e-3);
  }

  TEST(Contour, ClosesAlongTheDomainAndAlongMovedWalls)
  {
    // A bar through the whole height; walls moved in cut it at 1.337 and -0.71, between nodes.
    const Mesh mesh = square_mesh(40);
    const auto bar = sampled(mesh, [](const Point &x) { return 0.3 - std::abs(x[0]); });
    const Box walls{{-1., -0.71}, {1., 0.337}};
    const auto lines = contour(bar, mesh, Profile::straight, walls);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(enclosed_area(lines), 0.6 * 1.047, 1e-12);
    EXPECT_NEAR(interface_length(lines, walls), 2 * 1.047, 1e-12);
  }

  TEST(Contour, SplitsOrJoinsADiagonalByTheMean)
  {
    scene::Domain domain;
    domain.size = {5., 5.}, domain.cells = {5, 5};
    const Mesh mesh = make_mesh(domain);
    for (const double mean : {0.2, -0.2})
    {
      Field<double> field(mesh, -1.);
      field(2, 2) = field(3, 3) = 1. + mean;
      field(3, 2) = field(2, 3) = -1. + mean;
      EXPECT_EQ(contour(field, mesh, Profile::straight).size(), mean > 0. ? 1u : 2u);
    }
  }

  TEST(Contour, FindsNothingInAPureMelt)
  {
    const Mesh mesh = square_mesh(8);
    EXPECT_TRUE(contour(Field<float>(mesh, -1.f), mesh).empty());
  }
} // namespace medium
