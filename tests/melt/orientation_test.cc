#include "melt/orientation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "seed.h"

namespace
{
  using test::Boundary;
  using test::Field;
  using test::Mesh;

  /// Rigid rotation about the middle, written on ghosts too.
  medium::Velocity rotation(const Mesh &mesh, double rate)
  {
    medium::Velocity velocity(mesh);
    const test::Point middle = mesh.position(mesh.nodes[0] / 2, mesh.nodes[1] / 2);
    for (int j = -3; j < mesh.nodes[1] + 3; ++j)
      for (int i = -3; i < mesh.nodes[0] + 3; ++i)
      {
        velocity.x(i, j) = -rate * (mesh.position(i, j) - middle)[1];
        velocity.y(i, j) = rate * (mesh.position(i, j) - middle)[0];
      }
    return velocity;
  }
} // namespace

TEST(Orientation, CosineAndSineNeedNoLibrary)
{
  const Mesh mesh = test::square_mesh(65, 0.1, Boundary::no_flux);
  Field<double> angle(mesh), cosine(mesh), sine(mesh);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      angle(i, j) = 0.003 * (65 * j + i) - 6.;
  melt::cos_sin_of_four_times(angle, cosine, sine);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
    {
      ASSERT_NEAR(cosine(i, j), std::cos(4. * angle(i, j)), 5e-15);
      ASSERT_NEAR(sine(i, j), std::sin(4. * angle(i, j)), 5e-15);
    }
}

TEST(Orientation, QuartersOfARightAngleAreExact)
{
  const melt::Orientation diagonal = melt::make_orientation(45.),
                          back = melt::make_orientation(-22.5);
  EXPECT_EQ(diagonal.uniform_cosine, -1.);
  EXPECT_EQ(diagonal.uniform_sine, 0.);
  EXPECT_EQ(back.uniform_cosine, 0.);
  EXPECT_EQ(back.uniform_sine, -1.);
  EXPECT_NEAR(melt::make_orientation(15.).uniform_sine, std::sqrt(3.) / 2., 1e-15);
}

// A rigid rotation turns the lattice by the body's own angle: half the curl, not the whole.
TEST(Orientation, TurnsWithTheBodyNotTwiceAsFast)
{
  const Mesh mesh = test::square_mesh(33, 0.1, Boundary::no_flux);
  melt::Orientation orientation = melt::make_orientation(10.);
  medium::Advection advection(mesh, scene::AdvectionScheme::cip);
  const medium::Velocity velocity = rotation(mesh, 0.7);
  for (int step = 0; step < 50; ++step)
    melt::advance_orientation(orientation, velocity, 0.01, mesh, advection);
  for (int j = 0; j < 33; ++j)
    for (int i = 0; i < 33; ++i)
      ASSERT_NEAR(orientation.angle(i, j), 10. * M_PI / 180. + 0.35, 1e-12);
  EXPECT_NEAR(orientation.cosine(7, 9), std::cos(4. * orientation.angle(7, 9)), 1e-14);
}

// Shear v = (0, -g x): spin -g/2.
TEST(Orientation, ShearTurnsByHalfItsRate)
{
  const Mesh mesh = test::square_mesh(33, 0.1, Boundary::no_flux);
  melt::Orientation orientation = melt::make_orientation(0.);
  medium::Advection advection(mesh, scene::AdvectionScheme::cip);
  medium::Velocity velocity(mesh);
  for (int j = -3; j < 36; ++j)
    for (int i = -3; i < 36; ++i)
      velocity.y(i, j) = -0.4 * mesh.position(i, j)[0];
  for (int step = 0; step < 20; ++step)
    melt::advance_orientation(orientation, velocity, 0.01, mesh, advection);
  EXPECT_NEAR(orientation.angle(12, 20), -0.4 * 0.5 * 0.2, 1e-13);
}

// A crystal grown at a crystal angle is the unrotated one, turned: same reach along its own axis.
TEST(Orientation, CrystalsGrownAtAnyAngleReachEquallyFar)
{
  const int nodes = 161;
  const Mesh mesh = test::square_mesh(nodes, 0.4, Boundary::no_flux);
  const test::Point middle = mesh.position(nodes / 2, nodes / 2);
  std::vector<double> reach;
  for (const double degrees : {0., 15., 45.})
  {
    test::Melt melt = test::seeded(mesh, middle, 5., 0.55);
    melt::Growth growth(mesh, test::paper_law(0.05), melt::GrowthOptions{}, 0.55);
    const melt::Orientation orientation = melt::make_orientation(degrees);
    growth.advance(melt.fields(&orientation), 0.8 * growth.step_limit(), 2200);
    const double angle = degrees * M_PI / 180.;
    double low = 0., high = 30.; // where phi, interpolated bilinearly, changes sign on the axis
    for (int halving = 0; halving < 40; ++halving)
    {
      const double s = 0.5 * (low + high);
      const test::Point x =
          (middle + s * test::Point(std::cos(angle), std::sin(angle))) / mesh.spacing[0];
      const int i = static_cast<int>(x[0]), j = static_cast<int>(x[1]);
      const double a = x[0] - i, b = x[1] - j;
      const double phi = (1 - a) * (1 - b) * melt.phi(i, j) + a * (1 - b) * melt.phi(i + 1, j) +
                         (1 - a) * b * melt.phi(i, j + 1) + a * b * melt.phi(i + 1, j + 1);
      (phi > 0. ? low : high) = s;
    }
    reach.push_back(low);
  }
  EXPECT_GT(reach[0], 20.);
  EXPECT_NEAR(reach[1] / reach[0], 1., 0.02);
  EXPECT_NEAR(reach[2] / reach[0], 1., 0.02);
}
