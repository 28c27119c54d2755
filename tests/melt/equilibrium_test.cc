// A crystal that rests in its own melt has Wulff's shape.
#include <gtest/gtest.h>

#include "melt/growth.h"
#include "melt/tip.h"
#include "seed.h"

namespace
{
  using test::Boundary;

  struct Rest
  {
    double along = 0., across = 0.; // from the centre to the front along the axes and between them
    double theta = 0.;
  };

  /// A quarter of a disc in a small closed box, as it has come to rest.
  Rest crystal_at_rest(const double anisotropy)
  {
    const medium::Mesh mesh = test::square_mesh(49, 0.5, Boundary::symmetry);
    test::Melt melt = test::seeded(mesh, {0., 0.}, 12., 0.1);
    melt::Growth growth(mesh, test::paper_law(anisotropy), melt::GrowthOptions{}, 0.1);
    const double h = 0.8 * growth.step_limit();
    growth.advance(melt.fields(), h, static_cast<long>(600. / h));
    const auto radius = [&](const medium::Point &direction) {
      return melt::find_tip(melt.phi, mesh, {{0., 0.}, direction}, 1.).value().position;
    };
    return {radius({1., 0.}), radius({1., 1.}), melt.theta(0, 0)};
  }
} // namespace

// Wulff: the support function of the shape is gamma(n) d0/(-theta), gamma = 1 + eps cos(4 n). Where
// the normal is along a ray from the centre, on the axes and between them, it is the distance.
TEST(Equilibrium, OfACrystalHasTheShapeOfWulff)
{
  for (const double eps : {0.02, 0.04})
  {
    const Rest rest = crystal_at_rest(eps);
    EXPECT_NEAR(rest.along / rest.across, (1. + eps) / (1. - eps), 5e-4);
    EXPECT_NEAR(-rest.theta * rest.along / 0.185, 1. + eps, 0.005);
    EXPECT_NEAR(-rest.theta * rest.across / 0.185, 1. - eps, 0.005);
  }
}
