// A step of the material points: a plastic block at rest in itself, 640 000 points, with the
// default scheme and with the paper's.
#include <memory>

#include "kernels.h"
#include "solid/solid.h"

namespace kernels
{
  namespace
  {
    constexpr int side = 400;

    std::shared_ptr<scene::Scene> plastic_block()
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
      return scene;
    }

    void add_step(const std::string &name, const scene::ShapeFunction shape,
                  const scene::Transfer transfer)
    {
      add(name, {4. * side * side, 75., 45.},
          [shape, transfer]
          {
            const auto scene = plastic_block();
            scene->mpm->shape_function = shape, scene->mpm->transfer = transfer;
            auto solid = std::make_shared<solid::Owner>(solid::make_solid(*scene, 1));
            return [scene, solid] // the scene outlives the solid
            { solid::advance(**solid, solid::stable_step(**solid)); };
          });
    }
  } // namespace

  void add_solid_kernels()
  {
    add_step("material points", scene::ShapeFunction::quadratic_bspline, scene::Transfer::tpic);
    add_step("material points, uGIMP and FLIP", scene::ShapeFunction::ugimp, scene::Transfer::flip);
  }
} // namespace kernels
