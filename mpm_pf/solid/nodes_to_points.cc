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

    // What happens to a piece of a block, in this order.
    struct Stages
    {
      Solid &solid;
      const Step step;
      const Part part;
      CellMeans *const means;
      const Interpolation at = solid.interpolation();
      const bool apic = solid.scheme.transfer == Transfer::apic;

      void kinematics(const Piece &piece)
      {
        alignas(64) double vx[piece_points], vy[piece_points];
        const Moving by = solid.scheme.incremental() ? Moving{vx, vy} : Moving{};
        if (part == Part::stress)
          gather_gradient(at, solid.points, piece.points);
        else
          gather(at, solid.points, by, piece.points);
        move_as_prescribed(solid.supports, solid.points, part == Part::stress, piece.points);
        if (means)
          add_to_cells(*means, solid.points, solid.grid, step, piece);
        if (!apic && part != Part::stress)
          move(solid.points, by, step, solid.shares[piece.block], piece.points);
      }

      void stresses(const Piece &piece)
      {
        if (part == Part::motion)
          return;
        update_stress(solid.points, step, means, solid.shares[piece.block], piece.points);
        if (solid.points.may_split && solid.steps % stretch_interval == 0)
          stretch(solid.points, stretch_interval * step.dt, piece.points);
        if (!apic)
          return;
        // Its affine part takes the place of the velocity gradient, and needs the old position.
        gather_affine(at, solid.points, piece.points);
        move_as_prescribed(solid.supports, solid.points, part == Part::stress, piece.points);
        move(solid.points, Moving{}, step, solid.shares[piece.block], piece.points);
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
    const auto kinematics = [&](const Piece &piece) { stages.kinematics(piece); };
    const auto stresses = [&](const Piece &piece) { stages.stresses(piece); };
#pragma omp parallel num_threads(solid.threads)
    if (stages.means)
      in_turn(
          grid.blocks,
          [&](const int b) { clear_cells(cells, grid, b), for_pieces(grid.blocks, b, kinematics); },
          [&](const int b) { average_cells(cells, grid, b); },
          [&](const int b) { for_pieces(grid.blocks, b, stresses); });
    else
      each(grid.blocks,
           [&](const int b) {
             for_pieces(grid.blocks, b,
                        [&](const Piece &piece) { kinematics(piece), stresses(piece); });
           });
  }
} // namespace solid
