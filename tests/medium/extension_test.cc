#include "medium/extension.h"

#include <cmath>

#include <gtest/gtest.h>

#include "medium/reinitialisation.h"

namespace medium
{
  namespace
  {
    constexpr double width = 0.1, radius = 0.5;
    const Point centre(0.013, -0.021);

    struct Disc
    {
      explicit Disc(int cells,
                    scene::ExtensionMethod method = scene::ExtensionMethod::closest_point)
      {
        scene::Domain domain;
        domain.lower = {-1., -1.}, domain.size = {2., 2.}, domain.cells = {cells, cells};
        mesh = make_mesh(domain);
        phi = Field<double>(mesh);
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
            phi(i, j) = std::tanh((radius - (mesh.position(i, j) - centre).norm()) /
                                  (std::sqrt(2.) * width));
        fill_ghosts(phi, mesh);
        settings.method = method;
        settings.band = 0.3 / mesh.spacing[0];
      }
      /// `function` in the solid, extended from there; the liquid holds rubbish before.
      template <class Function>
      Field<double> extended(Function function)
      {
        Extension extension(mesh, settings, width);
        Field<double> field(mesh, 1e3);
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
            if (phi(i, j) > 0.)
              field(i, j) = function(mesh.position(i, j));
        extend_into_liquid(extension, {&field}, phi, material, mesh);
        return field;
      }
      /// Largest deviation from the value at the closest point of the disc, up to `reach` from it.
      template <class Function>
      double error(Function function, double reach)
      {
        const Field<double> field = extended(function);
        double largest = 0.;
        for (int j = 0; j < mesh.nodes[1]; ++j)
          for (int i = 0; i < mesh.nodes[0]; ++i)
          {
            const Point from = mesh.position(i, j) - centre;
            const double r = from.norm();
            if (r < radius + reach)
              largest = std::max(
                  largest, std::abs(field(i, j) -
                                    function(Point(centre + from * std::min(1., radius / r)))));
          }
        return largest;
      }

      Mesh mesh;
      Field<double> phi;
      Field<unsigned char> material;
      scene::Extension settings;
    };

    double smooth(const Point &x)
    {
      return std::sin(2. * x[0] + 0.3) * std::cos(1.5 * x[1]);
    }
    constexpr scene::ExtensionMethod both[] = {scene::ExtensionMethod::closest_point,
                                               scene::ExtensionMethod::pde};
  } // namespace

  TEST(Extension, ReproducesAUniformVelocityEverywhere)
  {
    for (const auto method : both)
    {
      Disc disc(60, method);
      EXPECT_LT(disc.error([](const Point &) { return 0.37; }, 2.), 1e-14);
    }
  }

  TEST(Extension, IsSecondOrderInTheBandAndFirstBeyond)
  {
    Disc coarse(60), fine(120);
    EXPECT_GT(std::log2(coarse.error(smooth, 0.25) / fine.error(smooth, 0.25)), 1.7);
    EXPECT_GT(std::log2(coarse.error(smooth, 2.) / fine.error(smooth, 2.)), 0.8);
    EXPECT_LT(fine.error(smooth, 0.25), 2e-3);
  }

  TEST(Extension, ByDifferentialEquationIsFirstOrder)
  {
    Disc coarse(40, scene::ExtensionMethod::pde), fine(80, scene::ExtensionMethod::pde);
    const double ratio = coarse.error(smooth, 0.2) / fine.error(smooth, 0.2);
    EXPECT_GT(std::log2(ratio), 0.6);
  }

  TEST(Extension, KnowsTheValueOfASingleNodeButNoSlope)
  {
    Disc disc(40);
    disc.material = Field<unsigned char>(disc.mesh);
    disc.material(20, 28) = 1; // below the top of the disc, deep enough to be solid
    const Field<double> field = disc.extended([](const Point &x) { return 1. + x[1]; });
    const double there = 1. + disc.mesh.position(20, 28)[1];
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        ASSERT_NEAR(field(i, j), there, 1e-12) << i << ' ' << j;
  }

  TEST(Extension, CarriesTheValueOfTheNearerDisc)
  {
    Disc disc(80);
    const Point left(-0.5, 0.), right(0.45, 0.1);
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
      {
        const Point x = disc.mesh.position(i, j);
        const double distance = std::max(0.3 - (x - left).norm(), 0.3 - (x - right).norm());
        disc.phi(i, j) = std::tanh(distance / (std::sqrt(2.) * 0.05));
      }
    fill_ghosts(disc.phi, disc.mesh);
    const auto side = [&](const Point &x)
    { return (x - left).norm() < (x - right).norm() ? -1. : 1.; };
    const Field<double> field = disc.extended(side);
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
      {
        const Point x = disc.mesh.position(i, j);
        ASSERT_LE(std::abs(field(i, j)), 1. + 1e-12);
        if (std::abs((x - left).norm() - (x - right).norm()) > 2. * disc.mesh.spacing[0])
        {
          EXPECT_NEAR(field(i, j), side(x), 1e-12) << x.transpose();
        }
      }
  }

  TEST(Extension, TakesNodesWithoutMaterialForLiquid)
  {
    // The outer two cells of the solid and a strip through it have no mass; rubbish stands there.
    Disc disc(60);
    const double h = disc.mesh.spacing[0];
    disc.material = Field<unsigned char>(disc.mesh, 1);
    const auto linear = [](const Point &x) { return 1. + 2. * x[0] - x[1]; };
    Field<double> field(disc.mesh, -1e5);
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
      {
        const Point x = disc.mesh.position(i, j);
        disc.material(i, j) = (x - centre).norm() < radius - 1.2 * h;
        if (disc.material(i, j))
          field(i, j) = linear(x);
      }
    Extension extension(disc.mesh, disc.settings, width);
    extend_into_liquid(extension, {&field}, disc.phi, disc.material, disc.mesh);
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        if (disc.phi(i, j) > 0.)
        {
          EXPECT_NEAR(field(i, j), linear(disc.mesh.position(i, j)), 1e-10);
        }
  }

  TEST(Extension, IsZeroWhereNothingIsSolid)
  {
    Disc disc(40);
    disc.phi = Field<double>(disc.mesh, -1.);
    Field<double> field(disc.mesh, 7.);
    Extension extension(disc.mesh, disc.settings, width);
    extend_into_liquid(extension, {&field}, disc.phi, disc.material, disc.mesh);
    EXPECT_EQ(field(3, 4), 0.);
  }

  TEST(Extension, FollowsAMovingDiscBetweenTwoDrawingsOfItsMap)
  {
    Disc disc(60);
    Extension extension(disc.mesh, disc.settings, width);
    for (int call = 0; call < 6; ++call)
    {
      const Point middle = centre + Point(0.3 * call * disc.mesh.spacing[0], 0.);
      Field<double> field(disc.mesh, 1e3);
      for (int j = 0; j < disc.mesh.nodes[1]; ++j)
        for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        {
          const double depth = radius - (disc.mesh.position(i, j) - middle).norm();
          disc.phi(i, j) = std::tanh(depth / (std::sqrt(2.) * width));
          if (depth > 0.)
            field(i, j) = 1. + call;
        }
      fill_ghosts(disc.phi, disc.mesh);
      extend_into_liquid(extension, {&field}, disc.phi, disc.material, disc.mesh);
      for (const auto &[i, j] : {std::pair{0, 0}, {60, 0}, {30, 60}, {59, 59}})
        EXPECT_NEAR(field(i, j), 1. + call, 1e-14);
    }
  }

  TEST(Extension, LetsNewSolidInheritTheAngleOfTheFront)
  {
    // A disc whose angle rises outward grows by eight cells, a twentieth of a cell a step: what has
    // grown takes the angle of the front within two cells' rise; a slope must not be carried on.
    Disc disc(60);
    const double h = disc.mesh.spacing[0], slope = 0.1 / h;
    Extension extension(disc.mesh, disc.settings, width);
    Field<double> angle(disc.mesh), velocity(disc.mesh);
    EXPECT_THROW(extend_inherited(extension, {&angle}, disc.mesh), std::logic_error);
    const auto grow_to = [&](double size)
    {
      for (int j = 0; j < disc.mesh.nodes[1]; ++j)
        for (int i = 0; i < disc.mesh.nodes[0]; ++i)
          disc.phi(i, j) = std::tanh((size - (disc.mesh.position(i, j) - centre).norm()) /
                                     (std::sqrt(2.) * width));
      fill_ghosts(disc.phi, disc.mesh);
    };
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        angle(i, j) = slope * ((disc.mesh.position(i, j) - centre).norm() - radius);
    for (int step = 0; step <= 160; ++step)
    {
      grow_to(radius + 0.05 * h * step);
      extend_into_liquid(extension, {&velocity}, disc.phi, disc.material, disc.mesh);
      extend_inherited(extension, {&angle}, disc.mesh);
    }
    for (int j = 0; j < disc.mesh.nodes[1]; ++j)
      for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        if ((disc.mesh.position(i, j) - centre).norm() > radius + h)
        {
          EXPECT_LT(std::abs(angle(i, j)), 0.25);
        }
  }

  TEST(Reinitialisation, ConvergesAndLeavesTheContour)
  {
    double error[2], shift[2];
    for (int level = 0; level < 2; ++level)
    {
      Disc disc(40 << level);
      const double h = disc.mesh.spacing[0];
      Distance distance(disc.mesh, 0.3 / h);
      compute_distance(distance, disc.phi, disc.mesh);
      reinitialise(distance, disc.phi, width, disc.mesh);
      error[level] = shift[level] = 0.;
      for (int j = 0; j < disc.mesh.nodes[1]; ++j)
        for (int i = 0; i < disc.mesh.nodes[0]; ++i)
        {
          const double exact = radius - (disc.mesh.position(i, j) - centre).norm();
          const double wrong = std::abs(distance.psi(i, j) - exact);
          if (std::abs(exact) < 0.2)
            error[level] = std::max(error[level], wrong);
          if (std::abs(exact) < h)
            shift[level] = std::max(shift[level], wrong / h);
        }
    }
    EXPECT_LT(shift[0], 0.01);
    EXPECT_GT(std::log2(error[0] / error[1]), 1.5);
  }
} // namespace medium
