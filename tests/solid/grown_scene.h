// Scenes of the tests of growth, walls and splitting, without a file; stresses in units of the
// yield stress.
#pragma once

#include <cmath>

#include "medium/field.h"
#include "scene/scene.h"

namespace grown
{
  using scene::Point;

  inline scene::Scene scene(const Point &size, const std::array<int, 2> &cells)
  {
    scene::Scene scene;
    scene.domain.size = size, scene.domain.cells = cells;
    scene.clock.end = 1.;
    scene.solid = scene::Solid{};
    scene.solid->young_modulus = 1e4, scene.solid->poisson_ratio = 0.33;
    scene.solid->density = 1., scene.solid->yield_stress = 1.;
    scene.mpm = scene::Mpm{};
    return scene;
  }

  /// A scene whose points come from phi.
  inline scene::Scene growing(const Point &size, const std::array<int, 2> &cells)
  {
    scene::Scene asked = scene(size, cells);
    asked.phase_field = scene::PhaseField{};
    asked.growth = scene::Growth{};
    return asked;
  }

  inline scene::Body rectangle(const Point &corner, const Point &size)
  {
    scene::Body body;
    body.shape = scene::Rectangle{corner, size};
    return body;
  }

  /// phi = tanh((radius - |x - centre|)/(sqrt(2) W)).
  inline medium::Field<double> disc(const medium::Mesh &mesh, const Point &centre,
                                    const double radius, const double width)
  {
    medium::Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        phi(i, j) =
            std::tanh((radius - (mesh.position(i, j) - centre).norm()) / (std::sqrt(2.) * width));
    medium::fill_ghosts(phi, mesh);
    return phi;
  }
} // namespace grown
