// A motion that crosses the sides of the mesh: what comes in, what goes out.
#include "medium/sides.h"

#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "medium/advection.h"

namespace
{
  using medium::Boundary;
  using medium::Field;
  using medium::Image;
  using medium::Mesh;
  using scene::AdvectionScheme;

  constexpr double pi = 3.14159265358979323846;

  constexpr double drift = 0.5; // velocity along y; along x it is 1

  /// A profile without slope along x on the left side, of period 1 along y.
  double profile(double x, double y)
  {
    return std::sin(2. * pi * y) * std::cos(2.5 * x) + 0.3 * std::cos(2. * pi * (y - x * x));
  }

  struct Carried
  {
    AdvectionScheme scheme;
    Boundary left, right; // below and above all is periodic
    Image image;
    double shift; // cells a step along x

    /// What has entered by `time` keeps what the left side had when it did.
    double exact(double x, double y, double time) const
    {
      const double since = std::min(x, time);
      if (left == Boundary::fixed && since < time)
        return profile(0., y - drift * since);
      return profile(x - since, y - drift * time);
    }
  };

  std::ostream &operator<<(std::ostream &out, const Carried &c)
  {
    return out << "scheme " << static_cast<int>(c.scheme) << ", boundary "
               << static_cast<int>(c.left) << ", image " << static_cast<int>(c.image) << ", shift "
               << c.shift;
  }

  /// Largest error at any node at `time` on a unit square.
  double largest_error(const Carried &c, int cells, double time)
  {
    Mesh mesh;
    mesh.nodes = {cells + 1, cells + 1};
    mesh.spacing = {1. / cells, 1. / cells};
    mesh.boundary.fill(Boundary::periodic);
    mesh.boundary[static_cast<std::size_t>(scene::Edge::left)] = c.left;
    mesh.boundary[static_cast<std::size_t>(scene::Edge::right)] = c.right;
    Field<double> f(mesh);
    medium::Velocity velocity(mesh);
    velocity.x = Field<double>(mesh, 1.);
    velocity.y = Field<double>(mesh, drift);
    const auto at = [&](int i, int j) { return mesh.position(i, j); };
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i)
        f(i, j) = profile(at(i, j)[0], at(i, j)[1]);
    medium::Gradients gradients;
    gradients.image = c.image;
    medium::Advection advection(mesh, c.scheme);
    const int steps = static_cast<int>(std::lround(time * cells / c.shift));
    for (int step = 0; step < steps; ++step)
      advection.advect(f, gradients, velocity, time / steps);
    double largest = 0.;
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i)
      {
        const double error = std::abs(f(i, j) - c.exact(at(i, j)[0], at(i, j)[1], time));
        if (!(error <= largest)) // not a number counts as well
          largest = error;
      }
    return largest;
  }
} // namespace

// From beyond a symmetry side, in steps of 0.02 cells, a scalar came in with an error of 1 (it
// stood still there) and an angle with 18, which grew to 1e16.
TEST(Sides, WhatEntersHasWhatTheSideHadThenAndLeavesInOrder)
{
  struct Scheme
  {
    AdvectionScheme name;
    double order; // least order from 20 to 40 cells; where the sine enters WENO has its second
  };
  for (const Scheme &scheme : {Scheme{AdvectionScheme::cip, 2.3},
                               {AdvectionScheme::cip_hermite, 2.3},
                               {AdvectionScheme::weno5, 1.9},
                               {AdvectionScheme::upwind, 0.7}})
    for (const Boundary sides : {Boundary::no_flux, Boundary::symmetry})
      for (const Image image : {Image::scalar, Image::angle})
        for (const double shift : {0.4, 0.1, 0.02})
        {
          const Carried c{scheme.name, sides, sides, image, shift};
          const double fine = largest_error(c, 40, 0.5);
          EXPECT_GT(std::log2(largest_error(c, 20, 0.5) / fine), scheme.order) << c;
          // After three passages all has come in; upwind smears, but nothing grows.
          EXPECT_LT(largest_error(c, 40, 3.), scheme.name == AdvectionScheme::upwind ? 0.6 : 1e-3)
              << c;
        }
}

// A fixed side goes on sending what it has, profile(0, y) on lines along the velocity; its
// gradients come from a point reflection, of the second order.
TEST(Sides, AFixedSideSendsInWhatItHas)
{
  for (const AdvectionScheme scheme : {AdvectionScheme::cip, AdvectionScheme::cip_hermite})
    for (const double shift : {0.4, 0.1, 0.02})
    {
      const Carried c{scheme, Boundary::fixed, Boundary::no_flux, Image::scalar, shift};
      const double fine = largest_error(c, 40, 3.);
      EXPECT_GT(std::log2(largest_error(c, 20, 3.) / fine), 1.9) << c;
      EXPECT_LT(fine, 4e-3) << c;
    }
}

// Along a mirror nothing enters: what is symmetric about it keeps its vanishing slope there.
TEST(Sides, AMotionAlongAMirrorIsLeftAlone)
{
  medium::Departure along{0., -0.3, 1., 0.1, -0.1, 1.};
  EXPECT_FALSE(medium::depart_from_side(along, {true, false, false, false}));
  EXPECT_EQ(along.xy, 0.1);
  medium::Departure out{0.2, -0.3, 1., 0.1, -0.1, 1.};
  EXPECT_FALSE(medium::depart_from_side(out, {true, false, false, false}));
  EXPECT_TRUE(medium::depart_from_side(out, {false, true, false, false}));
  EXPECT_EQ(out.x, 0.);
  EXPECT_EQ(out.y, -0.3);
  EXPECT_EQ(out.xx, 0.);
}
