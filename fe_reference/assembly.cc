#include "assembly.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    // Cells evaluated at once by all threads, then added in order: the sums do not depend on the
    // number of threads.
    constexpr int batch_cells = 512;

    struct Batch
    {
      std::vector<double> force, tangent, smallest;
    };

    void evaluate_cell(const Problem &problem, const State &old, State &now, const int cell,
                       double *force, double *tangent, double *smallest)
    {
      const Discretisation &d = problem.mesh;
      const int points = d.points_per_cell;
      std::array<double, 18> u;
      for (int a = 0; a < d.nodes_per_cell; ++a)
        for (int c = 0; c < 2; ++c)
          u[2 * a + c] = now.u[2 * d.nodes_of(cell)[a] + c];
      const ElementTables tables{d.gradient.data() + cell * points * d.nodes_per_cell * 2,
                                 d.weight.data() + cell * points,
                                 d.mode.data() + cell * points * d.modes};
      const ElementRequest request{u.data(),
                                   old.points.data() + cell * points,
                                   now.points.data() + cell * points,
                                   force,
                                   tangent,
                                   now.time - old.time};
      *smallest = evaluate_element(d.degree, problem.material, tables, request);
    }

    // Held rows and columns go; their diagonal stays so that the matrix keeps its scale.
    void reduce(const Problem &problem, const int cell, double *matrix, Tangent &tangent)
    {
      const Discretisation &d = problem.mesh;
      const int size = 2 * d.nodes_per_cell;
      const auto unknown = [&](const int k) { return 2 * d.nodes_of(cell)[k / 2] + k % 2; };
      for (int k = 0; k < size; ++k)
      {
        const int held = unknown(k);
        if (!problem.supports.is_held[held])
          continue;
        const double jump = tangent.jump.empty() ? 0. : tangent.jump[held];
        const double diagonal = std::abs(matrix[k * size + k]);
        for (int i = 0; i < size; ++i)
        {
          if (!problem.supports.is_held[unknown(i)])
            tangent.correction[unknown(i)] -= matrix[i * size + k] * jump;
          matrix[i * size + k] = matrix[k * size + i] = 0.;
        }
        matrix[k * size + k] = diagonal;
        tangent.correction[held] += diagonal * jump;
      }
    }

    void add_forces(const Discretisation &d, const int cell, const double *force, State &now)
    {
      if (d.owned[cell])
        for (int k = 0; k < 2 * d.nodes_per_cell; ++k)
          now.internal[2 * d.nodes_of(cell)[k / 2] + k % 2] += force[k];
    }

    // Tractions grow with the length of their side: minus that stiffness, in the side's cell.
    void add_side_stiffness(const Problem &problem, const State &now, Tangent &tangent)
    {
      const Discretisation &d = problem.mesh;
      const int size = 2 * d.nodes_per_cell, side_size = 2 * (d.degree + 1);
      for (const Loads::Traction &traction : problem.loads.tractions)
        for (const Loads::LoadedSide &loaded : traction.sides)
        {
          const BoundarySide &side = loaded.side;
          if (!d.touched[side.cell])
            continue;
          const std::vector<double> stiffness =
              side_stiffness(traction, loaded, d, now.u, now.time);
          std::vector<double> matrix(size * size, 0.);
          const auto row = [&](const int i)
          {
            const int *nodes = d.nodes_of(side.cell);
            const int a = static_cast<int>(
                std::find(nodes, nodes + d.nodes_per_cell, side.node[i / 2]) - nodes);
            return 2 * a + i % 2;
          };
          for (int i = 0; i < side_size; ++i)
            for (int j = 0; j < side_size; ++j)
              matrix[row(i) * size + row(j)] = -stiffness[i * side_size + j];
          reduce(problem, side.cell, matrix.data(), tangent);
          tangent.system->add(side.cell, matrix.data());
        }
    }

    // Cells first .. last - 1; returns false as soon as one folds.
    bool assemble_batch(const Problem &problem, const State &old, State &now, Tangent *tangent,
                        const std::vector<int> &cells, Batch &batch)
    {
      const Discretisation &d = problem.mesh;
      const int count = static_cast<int>(cells.size()), size = 2 * d.nodes_per_cell;
      batch.force.resize(count * size);
      batch.tangent.resize(tangent ? count * size * size : 0);
      batch.smallest.resize(count);
#pragma omp parallel for schedule(static) num_threads(problem.threads)
      for (int k = 0; k < count; ++k)
        evaluate_cell(problem, old, now, cells[k], batch.force.data() + k * size,
                      tangent ? batch.tangent.data() + k * size * size : nullptr,
                      batch.smallest.data() + k);
      bool sound = true;
      for (int k = 0; k < count; ++k)
      {
        if (batch.smallest[k] < now.smallest_jacobian)
        {
          now.smallest_jacobian = batch.smallest[k];
          now.worst_cell = cells[k];
        }
        sound = sound && batch.smallest[k] > 0.;
        if (!sound)
          continue;
        add_forces(d, cells[k], batch.force.data() + k * size, now);
        if (tangent)
        {
          double *matrix = batch.tangent.data() + k * size * size;
          reduce(problem, cells[k], matrix, *tangent);
          tangent->system->add(cells[k], matrix);
        }
      }
      return sound;
    }

    // The smallest Jacobian of all processes, with its cell.
    void agree_on_worst_cell(State &now)
    {
      const double smallest = minimum_over_processes(now.smallest_jacobian);
      const double mine = now.smallest_jacobian == smallest ? now.worst_cell : HUGE_VAL;
      now.smallest_jacobian = smallest;
      now.worst_cell = static_cast<int>(minimum_over_processes(mine));
    }
  } // namespace

  bool assemble(const Problem &problem, const State &old, State &now, Tangent *tangent)
  {
    const Discretisation &d = problem.mesh;
    now.points.resize(old.points.size());
    now.internal.assign(d.unknowns(), 0.);
    now.smallest_jacobian = HUGE_VAL;
    if (tangent)
    {
      tangent->system->clear();
      tangent->correction.assign(d.unknowns(), 0.);
    }
    bool sound = true;
    Batch batch;
    std::vector<int> cells;
    for (int cell = 0; cell < d.cells && sound; ++cell)
    {
      if (d.touched[cell])
        cells.push_back(cell);
      if (static_cast<int>(cells.size()) == batch_cells || cell + 1 == d.cells)
      {
        sound = assemble_batch(problem, old, now, tangent, cells, batch);
        cells.clear();
      }
    }
    agree_on_worst_cell(now);
    if (!(now.smallest_jacobian > 0.))
      return false;
    now.external = external_forces(problem.loads, d, now.u, now.time);
    sum_over_processes(now.internal);
    if (problem.loads.any())
      sum_over_processes(now.external);
    if (tangent)
      add_side_stiffness(problem, now, *tangent);
    return true;
  }

  std::vector<double> residual(const State &state)
  {
    std::vector<double> difference(state.internal.size());
    for (std::size_t k = 0; k < difference.size(); ++k)
      difference[k] = state.internal[k] - state.external[k];
    return difference;
  }

  State initial_state(const Problem &problem, const scene::Scene &scene)
  {
    const Discretisation &d = problem.mesh;
    State state;
    state.u.assign(d.unknowns(), 0.);
    state.points.resize(d.cells * d.points_per_cell);
    for (const scene::Body &body : scene.bodies)
    {
      if (!body.initial_stress)
        continue;
      std::vector<scene::Function> stress;
      for (const scene::Expression &component : *body.initial_stress)
        stress.emplace_back(component);
      for (int cell = 0; cell < d.cells; ++cell)
        for (int q = 0; q < d.points_per_cell; ++q)
        {
          scene::Argument argument;
          for (int a = 0; a < d.nodes_per_cell; ++a)
            argument.X += d.shape[q * d.nodes_per_cell + a] * d.position[d.nodes_of(cell)[a]];
          argument.x = argument.X;
          if (scene::signed_distance(body, argument.X) < 0.)
            continue;
          Vector4 &sigma = state.points[cell * d.points_per_cell + q].stress;
          for (int c = 0; c < 4; ++c)
            sigma[c] = stress[c](argument);
        }
    }
    const State before = state;
    assemble(problem, before, state, nullptr);
    return state;
  }
} // namespace fe
