#include "solid/nodes_to_points.h"

#include "solid/blocks.h"
#include "solid/body.h"
#include "solid/splitting.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    Step constants(const Solid &solid, const double dt)
    {
      Step step;
      const Material &material = solid.material;
      step.dt = dt;
      step.plastic = material.yield_stress.has_value();
      step.flow = {material.shear, material.bulk, material.yield_stress.value_or(0.),
                   material.viscosity / dt};
      step.inverse_density = 1. / material.density;
      step.relaxation = solid.scheme.pressure_relaxation;
      step.lower = solid.domain.lower, step.upper = solid.domain.upper();
      bound_by_walls(solid.supports, solid.time + dt, step.lower, step.upper);
      const double fastest = 0.5 * solid.grid.dx / dt;
      step.speed_limit2 = fastest * fastest;
      return step;
    }

    // What happens to some points of a block, in this order.
    struct Stages
    {
      Solid &solid;
      const Step step;
      const Part part;
      CellMeans *const means;
      const bool apic = solid.scheme.transfer == Transfer::apic;

      void move_points(const int b, const Moving &by, const std::size_t p, const std::size_t q)
      {
        Points &points = solid.points;
        move(points, by.vx ? by.vx : &points.vx[p], by.vy ? by.vy : &points.vy[p], step,
             solid.shares[b], p, q);
      }

      void kinematics(const int b, const std::size_t p, const std::size_t q)
      {
        alignas(64) double vx[piece_points], vy[piece_points];
        const Moving by = solid.scheme.incremental() ? Moving{vx, vy} : Moving{};
        if (part == Part::stress)
          gather_gradient(solid.scheme, solid.supports.folds, solid.grid, solid.points, p, q);
        else
          gather(solid.scheme, solid.supports.folds, solid.grid, solid.points, by, p, q);
        move_as_prescribed(solid.supports, solid.points, part == Part::stress, p, q);
        if (means)
          add_to_cells(*means, solid.points, solid.grid, step, b, p, q);
        if (!apic && part != Part::stress)
          move_points(b, by, p, q);
      }

      void stresses(const int b, const std::size_t p, const std::size_t q)
      {
        if (part == Part::motion)
          return;
        update_stress(solid.points, step, means, solid.shares[b], p, q);
        if (solid.points.may_split && solid.steps % stretch_interval == 0)
          stretch(solid.points, stretch_interval * step.dt, p, q);
        if (!apic)
          return;
        // Its affine part takes the place of the velocity gradient, and needs the old position.
        gather_affine(solid.scheme, solid.supports.folds, solid.grid, solid.points, p, q);
        move_as_prescribed(solid.supports, solid.points, part == Part::stress, p, q);
        move_points(b, Moving{}, p, q);
      }
    };
  } // namespace

  void nodes_to_points(Solid &solid, const double dt, const Part part)
  {
    const Grid &grid = solid.grid;
    if (part != Part::motion)
      solid.shares.assign(grid.blocks.size(), Share{});
    const bool averaged = solid.scheme.anti_locking && part != Part::motion;
    Stages stages{solid, constants(solid, dt), part, averaged ? &solid.cells : nullptr};
    CellMeans &cells = solid.cells;
    const auto pieces = [&](const int b, auto &&f)
    { for_pieces(grid.blocks[b], [&](const std::size_t p, const std::size_t q) { f(b, p, q); }); };
    const auto kinematics = [&](const int b, const std::size_t p, const std::size_t q)
    { stages.kinematics(b, p, q); };
    const auto stresses = [&](const int b, const std::size_t p, const std::size_t q)
    { stages.stresses(b, p, q); };
#pragma omp parallel num_threads(solid.threads)
    if (stages.means)
      in_turn(
          grid.blocks, [&](const int b) { clear_cells(cells, grid, b), pieces(b, kinematics); },
          [&](const int b) { average_cells(cells, grid, b); },
          [&](const int b) { pieces(b, stresses); });
    else
      each(grid.blocks,
           [&](const int b)
           {
             pieces(b, [&](const int block, const std::size_t p, const std::size_t q)
                    { kinematics(block, p, q), stresses(block, p, q); });
           });
  }
} // namespace solid
