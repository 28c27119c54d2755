#include "melt/thin_interface.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "melt/anisotropy.h"

namespace
{
  struct Sections
  {
    scene::PhaseField phase;
    scene::Growth growth;
    scene::Heat heat;
    Sections()
    {
      phase.width = 1.;
      growth.capillary_length = 0.185;
      growth.relaxation_time = 1.;
      heat.diffusivity = 3.;
    }
  };
} // namespace

TEST(ThinInterface, CouplesByThePapersNumbers)
{
  const Sections s;
  const melt::Law law = melt::make_law(s.phase, s.growth, &s.heat);
  EXPECT_NEAR(law.coupling, 4.778, 5e-4);            // a1/0.185
  EXPECT_NEAR(melt::a2 * law.coupling, 2.994, 1e-3); // D tau0/W0^2 = 3 within 0.2 %
}

// xi = 1 + eps cos 4(angle - crystal), flux (xi^2 - 1 + isotropic) n - xi xi' t, against the
// trigonometry.
TEST(Anisotropy, PolynomialsAgreeWithTrigonometry)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1., 1.);
  constexpr double eps = 0.05, isotropic = 0.7;
  for (int sample = 0; sample < 1000; ++sample)
  {
    const double n = number(random), t = number(random), crystal = 3. * number(random);
    const double angle = 4. * (std::atan2(t, n) - crystal);
    const double xi = 1. + eps * std::cos(angle), slope = -4. * eps * std::sin(angle);
    const double c = eps * std::cos(4. * crystal), s = eps * std::sin(4. * crystal);
    EXPECT_NEAR(melt::face_flux(n, t, c, s, isotropic),
                (xi * xi - 1. + isotropic) * n - xi * slope * t, 1e-14);
    EXPECT_NEAR(melt::inverse_relaxation(n, t, c, s), 1. / (xi * xi), 1e-14);
  }
}

TEST(Anisotropy, HasNoDirectionWhereNothingPoints)
{
  EXPECT_EQ(melt::face_flux(0., 0., 0.05, 0., 1.), 0.);
  EXPECT_EQ(melt::inverse_relaxation(0., 0., 0.05, 0.), 1.);
  EXPECT_EQ(melt::face_flux(0.f, 0.f, 0.05f, 0.f, 1.f), 0.f);
  EXPECT_EQ(melt::inverse_relaxation(1e-8f, 1e-8f, 0.05f, 0.f), 1.f);
  EXPECT_NEAR(melt::inverse_relaxation(0.1f, 0.f, 0.05f, 0.f), 1.f / (1.05f * 1.05f), 1e-6f);
}

TEST(ThinInterface, SaysWhenItIsNotThin)
{
  EXPECT_EQ(melt::width_warning(0.185, 1.), ""); // the paper's
  EXPECT_EQ(melt::width_warning(0.139, 1.), ""); // D tau0/W0^2 = 4
  EXPECT_EQ(melt::profile_warning(0.5, 1., false), "");
  EXPECT_NE(melt::profile_warning(0.5, 1., true).find("is 0.5 cells"), std::string::npos);
  EXPECT_EQ(melt::profile_warning(1., 1., true), "");
  EXPECT_NE(melt::profile_warning(0.02, 0.1, false).find("is 0.2 cells"), std::string::npos);
  EXPECT_NE(melt::width_warning(0.0554, 1.).find("18.1 capillary lengths"), std::string::npos);
}
