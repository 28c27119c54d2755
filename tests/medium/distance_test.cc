#include "medium/distance.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "medium/contour.h"

namespace medium
{
  namespace
  {
    Mesh box_mesh(int cells, Boundary sides = Boundary::no_flux)
    {
      scene::Domain domain;
      domain.lower = {-1., -1.}, domain.size = {2., 2.}, domain.cells = {cells, cells};
      domain.boundary = {sides, sides, sides, sides};
      return make_mesh(domain);
    }

    template <class Function>
    Field<double> phase_field(const Mesh &mesh, double width, Function distance)
    {
      Field<double> phi(mesh);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          phi(i, j) = std::tanh(distance(mesh.position(i, j)) / (std::sqrt(2.) * width));
      fill_ghosts(phi, mesh);
      return phi;
    }

    template <class Function>
    double largest_error(const Mesh &mesh, const Distance &distance, Function exact)
    {
      double error = 0.;
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
        {
          const double here = exact(mesh.position(i, j));
          if (std::abs(here) < distance.band - 2. * mesh.spacing[0])
            error = std::max(error, std::abs(distance.psi(i, j) - here));
        }
      return error;
    }

    double circle(const Point &x)
    {
      return 0.6 - (x - Point(0.013, -0.021)).norm();
    }
  } // namespace

  TEST(Distance, IsAtLeastSecondOrderOnACircle)
  {
    // Fixed width of profile and of band: the error is that of the discretisation alone, down to
    // single precision, 1e-5 of a cell across a wide band, which the fourth level reaches.
    double error[4];
    for (int level = 0; level < 4; ++level)
    {
      const Mesh mesh = box_mesh(20 << level);
      Distance distance(mesh, 3 << level);
      compute_distance(distance, phase_field(mesh, 0.1, circle), mesh);
      error[level] = largest_error(mesh, distance, circle);
    }
    EXPECT_LT(error[1], 1e-3 * 0.05);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.9);
    EXPECT_GT(std::log2(error[1] / error[2]), 1.9);
    EXPECT_LT(error[3], 1e-5 * 0.0125);
  }

  TEST(Distance, KeepsTheContourInPlace)
  {
    const Mesh mesh = box_mesh(80);
    const double h = mesh.spacing[0];
    for (const double width : {1., 2., 2.5})
    {
      Distance distance(mesh, 8.);
      Field<double> phi = phase_field(mesh, width * h, circle);
      for (int call = 0; call < 10; ++call) // and it does not drift when repeated
      {
        compute_distance(distance, phi, mesh);
        phi = phase_field(mesh, 1., [](const Point &) { return 0.; });
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
            phi(i, j) = std::tanh(distance.psi(i, j) / (std::sqrt(2.) * width * h));
        fill_ghosts(phi, mesh);
      }
      for (const Polyline &line : contour(phi, mesh))
        for (const Point &vertex : line)
          EXPECT_LT(std::abs(circle(vertex)), 0.01 * h) << "after ten calls, W0/dx = " << width;
    }
  }

  TEST(Distance, TakesTheNearerOfTwoDiscs)
  {
    const Mesh mesh = box_mesh(80);
    const auto two = [](const Point &x) {
      return std::max(0.3 - (x - Point(-0.4, 0.03)).norm(), 0.25 - (x - Point(0.41, -0.02)).norm());
    };
    Distance distance(mesh, 20.);
    compute_distance(distance, phase_field(mesh, 0.05, two), mesh);
    EXPECT_LT(largest_error(mesh, distance, two), 0.02 * mesh.spacing[0]); // its centres included
  }

  TEST(Distance, StaysFiniteAtCornersAndOnSharpProfiles)
  {
    const Mesh mesh = box_mesh(60);
    const double h = mesh.spacing[0];
    const auto square = [](const Point &x)
    { return 0.5 - std::max(std::abs(x[0] - 0.007), std::abs(x[1] + 0.003)); };
    const auto exact = [&](const Point &x) // Euclidean distance outside the corners
    {
      const Point out = (x - Point(0.007, -0.003)).cwiseAbs() - Point(0.5, 0.5);
      return out.minCoeff() > 0. ? -out.norm() : -out.maxCoeff();
    };
    for (const double width : {0.1, 1., 2.})
    {
      Distance distance(mesh, 8.);
      compute_distance(distance, phase_field(mesh, width * h, square), mesh);
      const double error = largest_error(mesh, distance, exact);
      EXPECT_TRUE(std::isfinite(error));
      EXPECT_LT(error, 0.75 * h) << "W0/dx = " << width; // the corner itself is no crossing
    }
  }

  TEST(Distance, ReachesAcrossPeriodicSides)
  {
    const Mesh mesh = box_mesh(64, Boundary::periodic);
    const auto stripe = [](const Point &x) { return 0.1 - std::abs(x[0] - 0.87); };
    const auto wrapped = [&](const Point &x)
    { return std::max(stripe(x), stripe(x + Point(2., 0.))); };
    Distance distance(mesh, 10.);
    compute_distance(distance, phase_field(mesh, 0.06, wrapped), mesh);
    EXPECT_LT(largest_error(mesh, distance, wrapped), 0.01 * mesh.spacing[0]);
    EXPECT_GE(distance.piece(2, 10), 0);
  }

  TEST(Distance, HasNoBandWithoutAnInterface)
  {
    const Mesh mesh = box_mesh(20);
    Distance distance(mesh, 5.);
    compute_distance(distance, Field<float>(mesh, -1.f), mesh);
    EXPECT_EQ(distance.psi(3, 7), -distance.band);
    EXPECT_EQ(distance.piece(3, 7), -1);
    EXPECT_THROW(Distance(mesh, 2.), std::invalid_argument);
  }

  namespace
  {
    /// Distance from a node to the arc or segment that a piece stands for (see distance.h).
    double arc_distance(const ContourPiece &piece, const Point &x, double h)
    {
      const double rx = x[0] - piece.x, ry = x[1] - piece.y, curvature = piece.curvature;
      const double m = rx * piece.normal_x + ry * piece.normal_y,
                   s = ry * piece.normal_x - rx * piece.normal_y, square = rx * rx + ry * ry;
      const double under = 1. - 2. * curvature * m + curvature * curvature * square;
      if (under > 0.0025 && std::abs(s) / std::sqrt(under) <= h)
        return std::abs(2. * m - curvature * square) / (1. + std::sqrt(under));
      return std::hypot(s - std::clamp(s, -0.5 * h, 0.5 * h), m);
    }

    /// Nodes whose distance is not that of a piece that is nearest, found by asking all pieces.
    int nodes_with_another_owner(const Distance &distance, const Mesh &mesh)
    {
      const double h = mesh.spacing[0];
      int wrong = 0;
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
        {
          const Point x = mesh.position(i, j);
          double least = std::numeric_limits<double>::max();
          for (const ContourPiece &piece : distance.pieces)
            least = std::min(least, std::hypot(x[0] - piece.x, x[1] - piece.y));
          bool explained = false;
          for (const ContourPiece &piece : distance.pieces) // several may be nearest, to rounding
            if (std::hypot(x[0] - piece.x, x[1] - piece.y) < least + 1e-4 * h)
              explained = explained || std::abs(std::min(distance.band, arc_distance(piece, x, h)) -
                                                std::abs(distance.psi(i, j))) < 1e-3 * h;
          wrong += explained ? 0 : 1;
        }
      return wrong;
    }

    /// Discs at pseudo-random places, their edges made rough by `noise` at every node.
    Field<double> rough_discs(const Mesh &mesh, double width, double noise)
    {
      unsigned state = 12345;
      const auto random = [&state]
      { return ((state = state * 1664525u + 1013904223u) >> 8) / 16777216. - 0.5; };
      std::vector<Point> centres;
      for (int n = 0; n < 9; ++n)
        centres.emplace_back(1.6 * random(), 1.6 * random());
      return phase_field(mesh, width,
                         [&](const Point &x)
                         {
                           double d = -2.;
                           for (std::size_t n = 0; n < centres.size(); ++n)
                             d = std::max(d, 0.05 + 0.03 * static_cast<double>(n) -
                                                 (x - centres[n]).norm());
                           return d + noise * random();
                         });
    }
  } // namespace

  TEST(Distance, AsksOnlyNearbyNodesAndFindsTheSameOwners)
  {
    const Mesh mesh = box_mesh(100);
    const double h = mesh.spacing[0];
    for (const double noise :
         {0., 0.2, 2.}) // of a cell: smooth; wrinkled; a contour full of specks
    {
      Distance distance(mesh, 9.);
      compute_distance(distance, rough_discs(mesh, 2. * h, noise * h), mesh);
      EXPECT_GT(distance.pieces.size(), 400u);
      // A wrinkled contour has corners where a node or two may ask the second nearest piece.
      EXPECT_LE(nodes_with_another_owner(distance, mesh), noise > 0. ? 10 : 0)
          << "noise of " << noise << " cells";
    }
  }

  TEST(Distance, FollowedIsTheSameAsMeasuredAfresh)
  {
    const Mesh mesh = box_mesh(120);
    const double h = mesh.spacing[0];
    Distance followed(mesh, 8.), afresh(mesh, 8.);
    for (int step = 0; step < 20; ++step) // 2.5 cells at a time, across many tiles
    {
      const Field<double> phi = phase_field(
          mesh, 1.5 * h,
          [&](const Point &x)
          { return 0.15 + 2.5 * h * step * 0.4 - (x - Point(2.5 * h * step - 0.4, 0.1)).norm(); });
      step == 0 ? compute_distance(followed, phi, mesh) : update_distance(followed, phi, mesh);
      compute_distance(afresh, phi, mesh);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
        {
          ASSERT_EQ(followed.psi(i, j), afresh.psi(i, j)) << "step " << step;
          ASSERT_EQ(followed.piece(i, j), afresh.piece(i, j));
        }
    }
  }
} // namespace medium
