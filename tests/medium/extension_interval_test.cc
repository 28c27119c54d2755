// Extensions that do not measure the distance, or search the whole mesh, at every call: how often
// they do, and what they know in between.
#include "medium/extension.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace medium
{
  namespace
  {
    constexpr double width = 0.1, radius = 0.5;

    /// A disc that moves to the right through a velocity that rises with x.
    struct MovingDisc
    {
      MovingDisc(const int cells, const int interval, const int map_interval)
      {
        scene::Domain domain;
        domain.lower = {-1., -1.}, domain.size = {2., 2.}, domain.cells = {cells, cells};
        mesh = make_mesh(domain);
        phi = Field<double>(mesh), field = Field<double>(mesh);
        material = Field<unsigned char>(mesh);
        settings.band = 0.3 / mesh.spacing[0];
        settings.interval = interval, settings.map_interval = map_interval;
        extension.emplace(mesh, settings, width);
      }
      static double value(const Point &x) { return 1. + 2. * x[0]; }

      /// One call, with the disc's centre at (x, 0).
      void extend_at(const double x)
      {
        centre = {x, 0.};
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
          {
            const double depth = radius - (mesh.position(i, j) - centre).norm();
            phi(i, j) = std::tanh(depth / (std::sqrt(2.) * width));
            material(i, j) = depth > 0.;
            field(i, j) = depth > 0. ? value(mesh.position(i, j)) : 1e3;
          }
        fill_ghosts(phi, mesh);
        extend_into_liquid(*extension, {&field}, phi, material, mesh);
      }
      /// Calls while the disc moves by `way` between one and the next.
      void travel(const int calls, const double way)
      {
        for (int k = 0; k < calls; ++k)
          extend_at(way * k);
      }
      /// Largest deviation from the value at the closest point, up to 0.2 from the disc.
      double error() const
      {
        double largest = 0.;
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
          {
            const Point from = mesh.position(i, j) - centre;
            const double r = from.norm();
            if (r > radius && r < radius + 0.2)
              largest =
                  std::max(largest, std::abs(field(i, j) - value(centre + from * radius / r)));
          }
        return largest;
      }
      long measurements() const { return extension->measuring.calls; }

      Mesh mesh;
      Field<double> phi, field;
      Field<unsigned char> material;
      scene::Extension settings;
      std::optional<Extension> extension;
      Point centre;
    };
  } // namespace

  TEST(DistanceInterval, SaysHowOftenTheDistanceIsMeasured)
  {
    for (const auto &[interval, measured] : {std::pair{1, 12}, {2, 6}, {4, 3}, {12, 1}})
    {
      MovingDisc disc(60, interval, 100);
      disc.travel(12, 0.05 * disc.mesh.spacing[0]);
      EXPECT_EQ(disc.measurements(), measured) << interval;
    }
  }

  TEST(DistanceInterval, IsCutShortWhereTheFrontHasMovedOnByACell)
  {
    MovingDisc disc(60, 50, 100); // at 0.4 cells a call it has at the third: calls 0, 3, 6, 9
    disc.travel(12, 0.4 * disc.mesh.spacing[0]);
    EXPECT_EQ(disc.measurements(), 4);
    EXPECT_LT(disc.error(), 2. * 1.3 * disc.mesh.spacing[0]);
  }

  TEST(DistanceInterval, EndsWithEveryMap)
  {
    MovingDisc disc(60, 4, 6); // calls 0, 4, 6, 10
    disc.travel(12, 0.05 * disc.mesh.spacing[0]);
    EXPECT_EQ(disc.measurements(), 4);
  }

  // The melt takes the value of where the front was: off by its way times the slope, 2.
  TEST(DistanceInterval, IsOffByTheWayOfTheFrontSince)
  {
    double error[2];
    for (int n = 0; n < 2; ++n)
    {
      MovingDisc every(60, 1, 100), fourth(60, 4, 100);
      const double way = (n == 0 ? 0.2 : 0.1) * every.mesh.spacing[0];
      every.travel(8, way), fourth.travel(8, way); // the last is the third after a measurement
      error[n] = fourth.error();
      EXPECT_LT(every.error(), 0.1 * error[n]);
      EXPECT_NEAR(error[n], 2. * 3. * way, 0.2 * error[n]);
    }
    EXPECT_NEAR(error[0] / error[1], 2., 0.2);
  }

  TEST(DistanceInterval, GoesOnFromItsStateToTheSameBits)
  {
    MovingDisc whole(60, 4, 7), resumed(60, 4, 7);
    const double way = 0.2 * whole.mesh.spacing[0];
    whole.travel(3, way);
    unpack(*resumed.extension, resumed.mesh, pack(*whole.extension, whole.mesh));
    unpack_distance(*resumed.extension, resumed.mesh, pack_distance(*whole.extension, whole.mesh));
    const long before = whole.measurements();
    for (int k = 3; k < 12; ++k)
    {
      whole.extend_at(way * k), resumed.extend_at(way * k);
      for (int j = 0; j < whole.mesh.nodes[1]; ++j)
        for (int i = 0; i < whole.mesh.nodes[0]; ++i)
          ASSERT_EQ(whole.field(i, j), resumed.field(i, j)) << k << ": " << i << ' ' << j;
    }
    EXPECT_EQ(whole.measurements() - before, resumed.measurements());
    EXPECT_THROW(unpack_distance(*resumed.extension, resumed.mesh, {1., 2.}), std::runtime_error);
  }

  // A second disc appears in a far corner: to the map of before it is melt that moves with the
  // first one.
  TEST(MapInterval, SaysWhenPiecesAwayFromTheFrontAreFound)
  {
    for (const int map_interval : {2, 5})
    {
      MovingDisc disc(120, 1, map_interval);
      const Point second(-0.85, -0.85), beside(-0.7, -0.85); // of a radius of 0.1
      for (int call = 0; call < 6; ++call)
      {
        disc.centre = {0.4, 0.4};
        for (int j = 0; j < disc.mesh.nodes[1]; ++j)
          for (int i = 0; i < disc.mesh.nodes[0]; ++i)
          {
            const Point x = disc.mesh.position(i, j);
            const double of_first = 0.3 - (x - disc.centre).norm();
            const double of_second = call > 0 ? 0.1 - (x - second).norm() : -1.;
            disc.phi(i, j) = std::tanh(std::max(of_first, of_second) / (std::sqrt(2.) * 0.03));
            disc.material(i, j) = disc.phi(i, j) > 0.;
            disc.field(i, j) = of_second > 0. ? 7. : 1.;
          }
        fill_ghosts(disc.phi, disc.mesh);
        extend_into_liquid(*disc.extension, {&disc.field}, disc.phi, disc.material, disc.mesh);
        const Point node = (beside - disc.mesh.lower).cwiseQuotient(disc.mesh.spacing);
        const double there = disc.field(static_cast<int>(std::lround(node[0])),
                                        static_cast<int>(std::lround(node[1])));
        EXPECT_NEAR(there, call >= map_interval ? 7. : 1., 1e-9) << map_interval << ", " << call;
      }
    }
  }
} // namespace medium
