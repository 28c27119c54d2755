// A seed that grows up to a wall and is pressed by it, and how a world goes on.
#pragma once

#include "record/checkpoint.h"
#include "scene/scene.h"
#include "simulate.h"

namespace simulated
{
  /// A quarter of a seed below a wall that starts at once and touches it soon.
  inline scene::Scene pressed_seed()
  {
    scene::Scene scene;
    scene.units = scene::Units::w0_tau0_sigma_y;
    scene.domain.size = {20., 16.}, scene.domain.cells = {25, 20};
    scene.domain.boundary.fill(scene::Boundary::symmetry);
    scene::Body seed;
    seed.name = "seed", seed.shape = scene::Disc{{0., 0.}, 8.};
    scene.bodies = {seed};
    scene.phase_field = scene::PhaseField{};
    scene.phase_field->width = 1.;
    scene.growth = scene::Growth{};
    scene.heat = scene::Heat{};
    scene.heat->diffusivity = 3., scene.heat->undercooling = 0.55;
    scene.orientation = scene::Orientation{};
    scene.solid = scene::Solid{};
    scene.solid->young_modulus = 1e4, scene.solid->poisson_ratio = 0.33;
    scene.solid->density = 1., scene.solid->yield_stress = 1.;
    scene.mpm = scene::Mpm{};
    scene.mpm->mach = 1e-2;
    scene::Wall wall;
    wall.side = scene::Edge::top, wall.speed = 0.2, wall.travel = 9., wall.start_time = 0.;
    wall.contact_ramp = 4.;
    scene.walls = {wall};
    scene.clock.end = 1000.;
    return scene;
  }

  inline void go(World &world, const int steps)
  {
    for (int k = 0; k < steps && !finished(world); ++k)
      step(world, coupling_step(world));
  }

  inline record::Checkpoint state_of(const World &world)
  {
    record::Checkpoint state;
    save(world, state);
    return state;
  }
} // namespace simulated
