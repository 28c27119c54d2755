// Steps of Eqs. (1) and (2) on 1200 x 800 nodes.
#include <cmath>
#include <memory>

#include "kernels.h"
#include "melt/growth.h"

namespace kernels
{
  namespace
  {
    constexpr double nodes = 1200. * 800.;
    constexpr long steps = 16; // a run takes 32 to 512 between two looks

    struct Melt
    {
      medium::Field<double> phi, theta;
      melt::Orientation orientation;
      std::unique_ptr<melt::Growth> growth;
      std::unique_ptr<melt::Noise> noise;
    };

    melt::Law law()
    {
      return {1., 1., 0.05, melt::coupling_constant(0.185, 1.), 3.};
    }

    /// Many discs, so that fronts are everywhere; every tile active.
    std::shared_ptr<Melt> melt_full_of_fronts(scene::Precision precision)
    {
      const medium::Mesh mesh = mesh_of(1200, 800);
      auto melt = std::make_shared<Melt>();
      melt->phi = medium::Field<double>(mesh);
      melt->theta = medium::Field<double>(mesh, -0.55);
      for (int j = 0; j < 800; ++j)
        for (int i = 0; i < 1200; ++i)
          melt->phi(i, j) = std::tanh(4. * std::sin(0.05 * i) * std::sin(0.05 * j));
      melt::GrowthOptions options;
      options.precision = precision;
      options.tiles = false;
      melt->growth = std::make_unique<melt::Growth>(mesh, law(), options, 0.55);
      melt->orientation = melt::make_orientation(10.);
      return melt;
    }

    std::function<void()> stepping(const std::shared_ptr<Melt> &melt, double h)
    {
      return [melt, h]
      {
        melt->growth->advance({melt->phi.empty() ? nullptr : &melt->phi, &melt->theta,
                               &melt->orientation, melt->noise.get()},
                              h, steps);
      };
    }
  } // namespace

  void add_growth_kernels()
  {
    using scene::Precision;
    constexpr double h = 1e-4; // short, so that the fronts stay where they are
    add("growth, uniform angle", {steps * nodes, 9., 6.5},
        [] { return stepping(melt_full_of_fronts(Precision::double_precision), h); });
    add("growth, angle field", {steps * nodes, 11., 8.},
        []
        {
          auto melt = melt_full_of_fronts(Precision::double_precision);
          melt::allocate_angle_field(melt->orientation, mesh_of(1200, 800));
          return stepping(melt, h);
        });
    add("growth, single precision", {steps * nodes, 5., 3.5},
        [] { return stepping(melt_full_of_fronts(Precision::single_precision), h); });
    const auto heat_alone = [](bool noisy)
    {
      auto melt = melt_full_of_fronts(Precision::double_precision);
      melt->phi = {};
      for (int j = 0; j < 800; ++j)
        for (int i = 0; i < 1200; ++i)
          melt->theta(i, j) = 0.1 * std::sin(0.01 * i + 0.02 * j);
      if (noisy)
        melt->noise = std::make_unique<melt::Noise>(mesh_of(1200, 800),
                                                    melt::Noise::Options{1e-4, 3., 1, true});
      return stepping(melt, 0.01);
    };
    add("heat alone", {steps * nodes, 1.3, 1.}, [=] { return heat_alone(false); });
    add("heat with noise", {steps * nodes, 12., 6.}, [=] { return heat_alone(true); });
  }
} // namespace kernels
