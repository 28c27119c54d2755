// A step of the material points: a plastic block at rest in itself, 640 000 points.
#include <memory>

#include "kernels.h"
#include "solid/solid.h"

namespace kernels
{
  void add_solid_kernels()
  {
    constexpr int side = 400;
    add("material points", {4. * side * side, 75., 45.},
        []
        {
          auto scene = std::make_shared<scene::Scene>();
          scene->domain.size = {side + 20., side + 20.};
          scene->domain.cells = {side + 20, side + 20};
          scene::Body block;
          block.name = "block";
          block.shape = scene::Rectangle{{10., 10.}, {double(side), double(side)}};
          block.velocity[0].text = "1e-4*sin(X/30)";
          block.velocity[1].text = "0";
          scene->bodies.push_back(block);
          scene->solid.emplace();
          scene->solid->young_modulus = 1e4;
          scene->solid->poisson_ratio = 0.33;
          scene->solid->density = 1.;
          scene->solid->yield_stress = 1.;
          scene->mpm.emplace();
          scene->clock.end = 1.;
          auto solid = std::make_shared<solid::Owner>(solid::make_solid(*scene, 1));
          return [scene, solid]
          { solid::advance(**solid, solid::stable_step(**solid)); }; // the scene outlives the solid
        });
  }
} // namespace kernels
