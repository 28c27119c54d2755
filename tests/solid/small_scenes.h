// Scenes small enough for tests, written in C++: E = 1000, nu = 0.3, density 1, unless changed.
#pragma once

#include <algorithm>

#include "solid/solid.h"

namespace small
{
  inline scene::Expression text(const std::string &expression)
  {
    return {expression, {"test", 1, "test"}};
  }

  inline scene::Scene rectangle(const scene::Point &corner, const scene::Point &size,
                                const scene::Point &domain, const std::array<int, 2> &cells)
  {
    scene::Scene scene;
    scene.domain.size = domain, scene.domain.cells = cells;
    scene::Body body;
    body.name = "block", body.shape = scene::Rectangle{corner, size};
    body.velocity = {text("0"), text("0")};
    scene.bodies.push_back(body);
    scene::Solid solid;
    solid.young_modulus = 1000., solid.poisson_ratio = 0.3, solid.density = 1.;
    scene.solid = solid;
    scene.mpm.emplace();
    scene.clock.end = 1.;
    return scene;
  }

  inline void hold(scene::Scene &scene, const std::string &name, const scene::Where &where,
                   const std::optional<std::string> &x, const std::optional<std::string> &y)
  {
    scene::Support support;
    support.name = name, support.where = where, support.place = {"test", 2, "support"};
    if (x)
      support.displacement[0] = text(*x);
    if (y)
      support.displacement[1] = text(*y);
    scene.supports.push_back(support);
  }

  /// One number of the history by its name.
  inline double value_of(const solid::History &history, const std::string &name)
  {
    const auto found = std::find(history.names.begin(), history.names.end(), name);
    return history.row.at(static_cast<std::size_t>(found - history.names.begin()));
  }

  /// The sheared bar of the paper's Fig. 8, `cells` to its width.
  inline scene::Scene sheared_bar(const int cells, const double end)
  {
    scene::Scene scene = rectangle({2., 0.2}, {1., 2.}, {5., 2.4}, {5 * cells, 12 * cells / 5});
    scene.solid->young_modulus = 500., scene.solid->yield_stress = 1.;
    scene.mpm->mach = 2e-3, scene.mpm->points_per_cell = {2, 2};
    scene.clock.end = end;
    hold(scene, "top", scene::Edge::top, "0.4*ramp(t, 0.05)", "0");
    hold(scene, "bottom", scene::Edge::bottom, "-0.4*ramp(t, 0.05)", "0");
    return scene;
  }
} // namespace small
