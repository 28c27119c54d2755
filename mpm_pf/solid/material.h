// Constants of the solid: isotropic elasticity, von Mises yield, Perzyna viscosity.
#pragma once

#include <cmath>
#include <optional>

#include "scene/scene.h"

namespace solid
{
  struct Material
  {
    double shear = 0., bulk = 0., young = 0., poisson = 0.;
    double density = 0., density_scale = 1.; // as used; over the scene's
    std::optional<double> yield_stress;      // empty: elastic
    double viscosity = 0.;                   // 0: rate-independent

    double wave_modulus() const { return bulk + 4. / 3. * shear; }
    double wave_speed() const { return std::sqrt(wave_modulus() / density); }
  };

  /// From the scene's numbers; with `mach` and a reference speed V the density becomes
  /// M (Ma/V)^2, so that the wave speed is V/Ma. With loads that are slow beside the waves inertia
  /// does not matter, and a denser solid takes longer steps.
  inline Material make_material(const scene::Solid &solid, const std::optional<double> mach,
                                const double reference_speed)
  {
    Material material;
    material.young = solid.young_modulus, material.poisson = solid.poisson_ratio;
    material.shear = 0.5 * solid.young_modulus / (1. + solid.poisson_ratio);
    material.bulk = solid.young_modulus / (3. * (1. - 2. * solid.poisson_ratio));
    material.density = solid.density;
    material.yield_stress = solid.yield_stress;
    material.viscosity = solid.viscosity.value_or(0.);
    if (mach)
    {
      const double wanted = *mach / reference_speed;
      material.density = material.wave_modulus() * wanted * wanted;
      material.density_scale = material.density / solid.density;
    }
    return material;
  }
} // namespace solid
