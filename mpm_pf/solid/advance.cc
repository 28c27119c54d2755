// One explicit step of Eq. (4) with the stresses of the last one (USL), and as many of them as a
// call asks.
#include <cmath>

#include "record/stopwatch.h"
#include "solid/blocks.h"
#include "solid/body.h"
#include "solid/energy.h"
#include "solid/light_nodes.h"
#include "solid/mean_velocity.h"
#include "solid/mirrors.h"
#include "solid/nodes_to_points.h"
#include "solid/splitting.h"
#include "solid/state_check.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    // Even blocks touch two rows of nodes beyond their own; odd blocks clear what these leave.
    void clear_nodes(Grid &grid, const int block)
    {
      const int halo = block % 2 == 0 ? 2 : -2, row = grid.blocks[block].row;
      const bool last = block + 1 == static_cast<int>(grid.blocks.size());
      const auto [begin, end] =
          grid.range(std::max(row - halo, grid.row_begin),
                     last ? grid.row_end : std::min(row + rows_per_block + halo, grid.row_end));
      std::fill(grid.mass.begin() + begin, grid.mass.begin() + end, 0.);
      std::fill(grid.nodes.begin() + begin, grid.nodes.begin() + end, Node{});
    }

    void points_to_nodes(Solid &solid)
    {
      const record::PartTimer timer = record::time_part(solid.spent, "points to nodes");
      Grid &grid = solid.grid;
      const Interpolation at = solid.interpolation();
      const MomentumSource source = solid.momentum_source();
#pragma omp parallel num_threads(solid.threads)
      alternate(grid.blocks,
                [&](const int b)
                {
                  clear_nodes(grid, b);
                  for_pieces(grid.blocks, b,
                             [&](const Piece &piece) { scatter(at, source, grid, piece.points); });
                });
      fold_images(grid);
    }

    // v = (p + dt f)/m; nodes whose mass is only rounding keep what was brought to them.
    void move_nodes(Solid &solid, const double dt)
    {
      Grid &grid = solid.grid;
      const double least = 1e-14 * solid.material.density * grid.dx * grid.dx;
      const auto nodes = static_cast<std::ptrdiff_t>(grid.nodes.size());
      const bool with_change = !grid.change.empty();
#pragma omp parallel for schedule(static) num_threads(solid.threads)
      for (std::ptrdiff_t n = 0; n < nodes; ++n)
      {
        const Quad &node = grid.nodes[n].motion; // {p_x, f_x, p_y, f_y}
        const double mass = grid.mass[n], inverse = mass > 0. ? 1. / mass : 0.;
        const double push = mass > least ? dt * inverse : 0.;
        grid.velocity[n] = {node[0] * inverse + push * node[1], // Eq. (4)
                            node[2] * inverse + push * node[3]};
        if (with_change)
          grid.change[n] = {push * node[1], push * node[3]};
      }
    }

    void nodes(Solid &solid, const double dt)
    {
      const record::PartTimer timer = record::time_part(solid.spent, "nodes");
      apply_tractions(solid);
      if (const auto &X = solid.loads.parted)
        throw NumericalError(
            "the loaded edge that started there has parted from the material, which "
            "bears no such load; lower the traction",
            solid.steps, solid.time, *X);
      move_nodes(solid, dt);
      const HeldStep step{solid.time, dt};
      prescribe(solid, step);
      if (solid.scheme.node_mass_floor > 0. && !solid.scheme.stress_first)
        tie_light_nodes(solid.light_nodes, solid.supports, solid.grid,
                        solid.scheme.node_mass_floor * solid.material.density * solid.grid.dx *
                            solid.grid.dx,
                        dt, solid.threads);
      // v* is what the points bring, not what supports make of it.
      if (solid.scheme.transfer == Transfer::xpic2)
        smooth_velocity(solid.interpolation(), solid.points);
      apply_supports(solid.supports, solid.grid, step);
      add_traction_work(solid.loads, solid.grid, dt);
      move(solid.tracers, solid.interpolation(), dt);
    }

    // Stresses from the velocities which the points bring, held as over the step to come.
    void stresses_first(Solid &solid, const double dt)
    {
      points_to_nodes(solid);
      const record::PartTimer timer = record::time_part(solid.spent, "nodes to points");
      Grid &grid = solid.grid;
      for (Node &node : grid.nodes)
        node.motion[1] = node.motion[3] = 0.;
      move_nodes(solid, dt);
      const HeldStep trial{solid.time, dt, false};
      prescribe(solid, trial);
      apply_supports(solid.supports, grid, trial);
      nodes_to_points(solid, dt, Part::stress);
    }

    void sort_points(Solid &solid)
    {
      Grid &grid = solid.grid;
      const bool first = grid.blocks.empty() && solid.points.active > 0;
      if (!first && grid.drift < 0.25 * grid.dx)
        return;
      const record::PartTimer timer = record::time_part(solid.spent, "sorting");
      split_points(solid);
      sort(solid.points, grid, solid.scratch, solid.scheme.incremental(), solid.threads);
      solid.supports.marked.clear();
      refine(solid.tracers, grid.dx);
      resize_with_grid(solid);
    }
  } // namespace

  void step(Solid &solid, const double dt)
  {
    sort_points(solid);
    place_supports(solid.supports, solid.tracers, solid.grid, solid.time);
    evaluate_body_force(solid.loads, solid.points, solid.fraction, solid.time);
    const bool stress_first = solid.scheme.stress_first;
    if (stress_first)
      stresses_first(solid, dt);
    points_to_nodes(solid);
    add_body_force_work(solid.loads, solid.points, 0.5 * dt); // half with the velocities before,
    nodes(solid, dt);
    {
      const record::PartTimer timer = record::time_part(solid.spent, "nodes to points");
      nodes_to_points(solid, dt, stress_first ? Part::motion : Part::all);
    }
    move_held_points(solid, dt);
    add_body_force_work(solid.loads, solid.points, 0.5 * dt); // half with those after
    solid.time += dt;
    ++solid.steps;
    solid.last_step = dt;
    check_state(solid, dt);
  }

  void resize_with_grid(Solid &solid)
  {
    if (solid.scheme.anti_locking)
      solid.cells.resize(solid.grid.nodes.size(), solid.points.size());
    if (!solid.loads.tractions.empty())
      solid.loads.shares.find_near(solid.tracers, solid.points, solid.grid);
  }

  double stable_step(const Solid &solid)
  {
    const double fastest = std::max(solid.speed, solid.supports.speed);
    return solid.scheme.step_fraction * solid.grid.dx / (solid.material.wave_speed() + fastest);
  }

  namespace
  {
    // Parts of the limit omega dt = 2. Steps a and b in turn, as omega dt, have the trace
    // 2 - (a + b)^2 + a^2 b^2: stable up to the limit if equal, all pairs only up to 1/sqrt(2) of
    // it (Skeel, BIT 33, 172, 1993). What is recorded cuts steps short, so they become longer
    // beyond that only by what a change of speed asks for.
    bool may_follow(const double before, const double next)
    {
      return next <= std::sqrt(0.5) || before <= 0. || next <= 1.01 * before;
    }

    // Equal parts of what is left, no longer than the stable step and than may follow the last.
    double next_step(const Solid &solid, const double left)
    {
      const double stable = stable_step(solid), limit = stable / solid.scheme.step_fraction;
      double count = std::max(1., std::ceil(left / stable - 1e-9));
      while (!may_follow(solid.last_step / limit, left / count / limit))
        count += 1.;
      return left / count;
    }
  } // namespace

  void advance(Solid &solid, const double dt, NodalVelocity *mean)
  {
    const double start = solid.time;
    for (Support &support : solid.supports.all)
      support.call_impulse = Point::Zero();
    if (mean)
      reset(*mean, solid.domain);
    const bool walled = has_walls(solid.supports);
    const Point momentum_before = walled ? momentum(solid) : Point(0., 0.);
    double left = dt;
    while (left > 0.)
    {
      const double length = next_step(solid, left);
      step(solid, length);
      if (mean)
        add(*mean, solid.grid, solid.domain, length / dt);
      left = length < left ? left - length : 0.;
    }
    if (mean)
      finish(*mean), unfold(solid.supports, solid.domain, solid.grid, *mean);
    // The end is exactly where it was asked for, however many steps it took.
    solid.time = start + dt, solid.call_duration = dt;
    if (walled)
      add_wall_balance(solid, momentum_before);
  }
} // namespace solid
