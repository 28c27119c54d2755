// A free disc that breathes: the lowest radial vibration in plane strain, u_r = J1(k r).
#include <cmath>

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double radius = 1.5;

  /// The smallest k R without radial stress on the rim: (lambda + 2 mu) u' + lambda u/r = 0, that
  /// is k R J0(k R) = (1 - 2 nu)/(1 - nu) J1(k R).
  double wave_number_times_radius(const double nu)
  {
    double low = 1., high = 3.;
    while (high - low > 1e-12)
    {
      const double z = 0.5 * (low + high);
      const double stress =
          z * std::cyl_bessel_j(0., z) - (1. - 2. * nu) / (1. - nu) * std::cyl_bessel_j(1., z);
      (stress > 0. ? low : high) = z;
    }
    return low;
  }

  /// Starts with v_r ~ J1(k r), its series up to (k r)^9, about a centre that is no node.
  scene::Scene breathing_disc(const double nu, const double k)
  {
    scene::Scene scene = small::rectangle({1., 1.}, {3., 3.}, {5., 5.}, {40, 40});
    scene.bodies[0].shape = scene::Disc{{2.53, 2.47}, radius};
    scene.solid->poisson_ratio = nu;
    scene.mpm->points_per_cell = {3, 3};
    const std::string z =
        "(" + std::to_string(k * k) + "*((X - 2.53)^2 + (Y - 2.47)^2))"; // (k r)^2
    const std::string over_r =
        "1e-3*(1 - " + z + "/8*(1 - " + z + "/24*(1 - " + z + "/48*(1 - " + z + "/80))))";
    scene.bodies[0].velocity = {small::text("(X - 2.53)*" + over_r),
                                small::text("(Y - 2.47)*" + over_r)};
    return scene;
  }
} // namespace

// The kinetic energy is cos(omega t)^2 of the first: five quarters of a period later there is left
// of it (5/2 pi e + p)^2, e being omega's relative error, here at most 0.4 %, and p = omega h/2 the
// phase of velocities that stand half a step h before the positions.
TEST(Momentum, AFreeDiscBreathesAtItsFrequency)
{
  for (const double nu : {0., 0.25, 0.4})
  {
    const double k = wave_number_times_radius(nu) / radius;
    const scene::Scene scene = breathing_disc(nu, k);
    const solid::Owner disc = solid::make_solid(scene);
    const double period = 2. * pi / (k * solid::density_scaling(*disc).wave_speed);
    const double start = small::value_of(solid::history(*disc), "kinetic_energy");
    solid::advance(*disc, 1.25 * period);
    const double phase = 0.5 * k * 0.4 * 0.125; // h = 0.4 dx/c_p
    const double left = std::pow(2.5 * pi * 0.004 + phase, 2);
    EXPECT_LT(small::value_of(solid::history(*disc), "kinetic_energy"), left * start) << nu;
    solid::advance(*disc, 0.25 * period);
    EXPECT_NEAR(small::value_of(solid::history(*disc), "kinetic_energy") / start, 1., 0.02) << nu;
  }
}
