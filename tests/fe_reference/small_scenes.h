// Scenes for the tests of the finite elements, made in memory.
#pragma once

#include <string>

#include "fe_reference/load_stepping.h"

namespace fe_test
{
  inline scene::Expression expression(const std::string &text)
  {
    scene::Expression result;
    result.text = text;
    return result;
  }

  inline scene::Body rectangle(const double x, const double y, const double width,
                               const double height)
  {
    scene::Body body;
    body.shape = scene::Rectangle{{x, y}, {width, height}};
    return body;
  }

  /// Support named `name`; an empty text leaves the component free.
  inline scene::Support support(const std::string &name, const scene::Where &where,
                                const std::string &x, const std::string &y)
  {
    scene::Support result;
    result.name = name;
    result.where = where;
    if (!x.empty())
      result.displacement[0] = expression(x);
    if (!y.empty())
      result.displacement[1] = expression(y);
    return result;
  }

  inline scene::Scene solid_scene(const double young_modulus, const std::array<int, 2> &cells,
                                  const int degree, const int load_steps)
  {
    scene::Scene scene;
    scene.clock.end = 1.;
    scene.solid.emplace();
    scene.solid->young_modulus = young_modulus;
    scene.solid->poisson_ratio = 0.3;
    scene.solid->density = 1000.;
    scene.fe.emplace();
    scene.fe->cells = cells;
    scene.fe->degree = degree;
    scene.fe->load_steps = load_steps;
    return scene;
  }

  inline fe::Problem problem_of(const scene::Scene &scene)
  {
    fe::Problem problem;
    problem.mesh = fe::discretise(fe::make_mesh(scene), scene.fe->degree);
    problem.material = fe::make_material(scene.solid->young_modulus, scene.solid->poisson_ratio);
    problem.material.yield_stress = scene.solid->yield_stress;
    problem.material.viscosity = scene.solid->viscosity.value_or(0.);
    problem.supports = fe::make_supports(scene, problem.mesh);
    problem.loads = fe::make_loads(scene, problem.mesh);
    return problem;
  }

  /// March to the end of the clock; `observe` may be empty.
  inline fe::Outcome solve(const scene::Scene &scene, const fe::Problem &problem,
                           const std::function<void(const fe::Step &)> &observe = {},
                           const std::vector<double> &sampling_times = {})
  {
    fe::LinearSystem system(problem.mesh);
    fe::SteppingOptions options;
    options.end = scene.clock.end;
    options.load_steps = scene.fe->load_steps;
    options.sampling_times = sampling_times;
    options.observe = [&](const fe::Step &step)
    {
      if (observe)
        observe(step);
    };
    options.interrupted = [] { return false; };
    return fe::run_load_steps(problem, system, fe::initial_state(problem, scene), options);
  }

  /// Sum of the reactions of support number `index` in direction `component`.
  inline double reaction(const fe::Problem &problem, const fe::State &state, const int index,
                         const int component)
  {
    double sum = 0.;
    for (const int node : problem.supports.held[index].nodes[component])
      sum += state.internal[2 * node + component] - state.external[2 * node + component];
    return sum;
  }
} // namespace fe_test
