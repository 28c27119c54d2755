#include "solid/supports.h"

#include <algorithm>
#include <limits>

#include "solid/body.h"
#include "solid/mirrors.h"
#include "solid/walls.h"

namespace solid
{
  namespace
  {
    // Cells beyond the ends of a line in which shape functions are folded.
    constexpr std::array<double, 2> folded{1., 1.};

    void place_line(const std::vector<Support> &supports, const Tracers &tracers, HeldLine &line,
                    const double t)
    {
      if (line.support < 0)
        return;
      const Motion &motion = supports[line.support].motion;
      const int along = 1 - line.axis;
      double shift = 0.;
      for (const double s : {0., 0.5, 1.})
      {
        Point X;
        X[line.axis] = line.initial, X[along] = line.from + s * (line.to - line.from);
        shift += motion.at(X, X, t)[line.axis] / 3.;
      }
      line.position = line.initial + shift;
      if (line.bit == 0)
      {
        Point X;
        X[line.axis] = line.initial, X[along] = line.from;
        const double along_it = motion.at(X, X, t)[along];
        line.lower = line.from + along_it, line.upper = line.to + along_it;
        return;
      }
      line.lower = std::numeric_limits<double>::max(), line.upper = -line.lower;
      for (const auto &outline : tracers.outlines)
        for (const Tracer &tracer : outline)
          if (tracer.lines & line.bit)
          {
            line.lower = std::min(line.lower, tracer.x[along]);
            line.upper = std::max(line.upper, tracer.x[along]);
          }
      line.lower -= line.overhang[0], line.upper += line.overhang[1];
    }

    void mark(Supports &supports, Grid &grid, const std::ptrdiff_t n, const int axis,
              const int line)
    {
      auto &pairs = supports.folds.pairs;
      std::array<int, 2> wanted{-1, -1};
      if (grid.fold[n] > 0)
        wanted = pairs[grid.fold[n] - 1];
      else
        supports.marked.push_back(n);
      wanted[axis] = line;
      const auto found = std::find(pairs.begin(), pairs.end(), wanted);
      constexpr std::size_t most = std::numeric_limits<std::uint8_t>::max();
      if (found == pairs.end() && pairs.size() == most)
        throw std::runtime_error("more than " + std::to_string(most) +
                                 " pairs of held lines share nodes, which is all that the grid "
                                 "tells apart; hold edges by fewer supports");
      grid.fold[n] = static_cast<std::uint8_t>(found - pairs.begin() + 1);
      if (found == pairs.end())
        pairs.push_back(wanted);
    }

    /// The velocity of a support that moves as a whole.
    Point velocity_of(const Support *support, const HeldStep &step)
    {
      const Point zero(0., 0.);
      return support ? Point((support->motion.at(zero, zero, step.end()) -
                              support->motion.at(zero, zero, step.t)) /
                             step.dt)
                     : zero;
    }

    /// Notes what each wall touches, before any line gives its nodes another velocity.
    void note_touched(Supports &supports, const Grid &grid, const HeldStep &step)
    {
      for (std::size_t l = 0; l < supports.lines.size(); ++l)
      {
        HeldLine &line = supports.lines[l];
        if (!line.contact)
          continue;
        const Fold &fold = supports.folds.lines[l];
        const Point v = velocity_of(&supports.all[line.support], step);
        std::fill(line.touched.begin(), line.touched.end(), 0);
        for_nodes_along(
            line, grid, fold.carrier(), line.reach,
            [&](const int i, const int j, const std::ptrdiff_t n)
            {
              const std::size_t k = line.index(i, j);
              line.touched[k] = touches(line, fold, grid, {i, j, n, v, line.stuck[k] != 0});
            });
        if (step.count_reaction)
          line.stuck = line.touched;
      }
    }

    /// Does another line hold node (i, j) = n across itself, which is along `line`?
    bool crossed(const Supports &supports, const HeldLine &line, const Grid &grid, const int i,
                 const int j, const std::ptrdiff_t n)
    {
      const int along = 1 - line.axis;
      if (on_mirror(grid, along, i, j))
        return true;
      const int l = grid.fold[n] == 0 ? -1 : supports.folds.pairs[grid.fold[n] - 1][along];
      if (l < 0 || !supports.lines[l].held[along] ||
          (along == 0 ? i : j) != supports.folds.lines[l].carrier())
        return false;
      const HeldLine &other = supports.lines[l];
      return !other.contact || other.touched[other.index(i, j)];
    }

    /// Does a support hold what a symmetry side would hold, node k of its carriers? Then the push
    /// is the support's, and its motion counts.
    bool held_by_support(const Supports &supports, const HeldLine &side, const Grid &grid,
                         const int carrier, const int k)
    {
      for (std::size_t l = 0; l < supports.lines.size(); ++l)
      {
        const HeldLine &line = supports.lines[l];
        if (line.support < 0 || line.contact || line.axis != side.axis ||
            supports.folds.lines[l].carrier() != carrier)
          continue;
        const auto [first, last] = nodes_within(line, grid, line.reach);
        if (k >= first && k <= last)
          return true;
      }
      return false;
    }

    void apply_line(Supports &supports, const HeldLine &line, const Fold &fold, Grid &grid,
                    const HeldStep &step)
    {
      Support *const support = line.support < 0 ? nullptr : &supports.all[line.support];
      const bool uniform = !support || support->motion.uniform;
      Point v = uniform ? velocity_of(support, step) : Point(0., 0.);
      supports.speed = std::max(supports.speed, v.norm());
      for_nodes_along(
          line, grid, fold.carrier(), line.reach,
          [&](const int i, const int j, const std::ptrdiff_t n)
          {
            if (!uniform)
            {
              Point x{grid.node_x(i), grid.node_y(j)};
              x[line.axis] = line.position;
              const Point X = support->motion.origin(x, step.t, grid.dx);
              v = (support->motion.at(X, x, step.end()) - support->motion.at(X, x, step.t)) /
                  step.dt;
            }
            if (line.contact && !line.touched[line.index(i, j)])
              return;
            if (!support &&
                held_by_support(supports, line, grid, fold.carrier(), line.axis == 0 ? j : i))
              return;
            std::array<bool, 2> held = line.held;
            if (held[1 - line.axis] && crossed(supports, line, grid, i, j, n))
              held[1 - line.axis] = false; // the other's push is not ours to undo
            set_velocity(supports, step.count_reaction ? support : nullptr, grid,
                         {n, held, v, line.contact});
          });
    }

    // What a rigid grip takes beyond what its sides do, as that of driven points (driven.cc).
    struct Account
    {
      Point velocity;
      double dt;
      Point impulse;
      double work;
      void add_reaction(const Points &points, const std::size_t p, const Acceleration &acceleration)
      {
        const Point before(points.vx[p], points.vy[p]);
        const Point push = dt * points.mass[p] * acceleration.at(p);
        impulse += points.mass[p] * (velocity - before) - push;
        work += 0.5 * points.mass[p] * (velocity.squaredNorm() - before.squaredNorm()) -
                0.5 * push.dot(velocity + before);
      }
    };
  } // namespace

  void set_velocity(Supports &supports, Support *support, Grid &grid, const HeldNode &given)
  {
    const auto &[n, held, v, met] = given;
    Node &node = grid.nodes[n];
    const double mass = grid.mass[n];
    Velocity &velocity = grid.velocity[n];
    Point now{velocity.x, velocity.y}, impulse = Point::Zero();
    double work = 0.;
    for (int c = 0; c < 2; ++c)
      if (held[c])
      {
        const double before = mass > 0. ? node.momentum()[c] / mass : v[c];
        impulse[c] = mass * (v[c] - now[c]);
        // A support has gone with its node since the step before, and works on their mean velocity;
        // a wall works on its own, and what is lost as they meet is lost.
        work += impulse[c] * (met ? v[c] : 0.5 * (v[c] + before));
        now[c] = v[c];
        if (!grid.change.empty())
          (c == 0 ? grid.change[n].x : grid.change[n].y) = v[c] - before;
        node.motion[2 * c] = mass * v[c];
      }
    velocity = {now[0], now[1]};
    if (!support)
      return;
    support->impulse += impulse, support->call_impulse += impulse;
    supports.work += work, supports.work_done += std::abs(work);
    supports.speed = std::max(supports.speed, v.norm());
  }

  void place_supports(Supports &supports, const Tracers &tracers, Grid &grid, const double t)
  {
    for (const std::ptrdiff_t n : supports.marked)
      if (n < static_cast<std::ptrdiff_t>(grid.fold.size()))
        grid.fold[n] = 0;
    supports.marked.clear(), supports.folds.pairs.clear(), supports.folds.lines.clear();
    for (std::size_t l = 0; l < supports.lines.size(); ++l)
    {
      HeldLine &line = supports.lines[l];
      place_line(supports.all, tracers, line, t);
      const Fold fold = fold_at(line.position, line.side, grid.lower[line.axis], grid.dx);
      supports.folds.lines.push_back(fold);
      if (line.reflects)
        continue;
      for (const int row : {fold.carrier(), fold.master})
        for_nodes_along(line, grid, row, folded,
                        [&](int, int, const std::ptrdiff_t n)
                        { mark(supports, grid, n, line.axis, static_cast<int>(l)); });
    }
    if (!supports.edges.empty())
      locate_turning_edges(supports, tracers, grid);
  }

  void apply_supports(Supports &supports, Grid &grid, const HeldStep &step)
  {
    if (!supports.driven.empty())
      apply_driven_regions(supports, grid, step.count_reaction);
    if (!supports.edges.empty())
      apply_turning_edges(supports, grid, step);
    note_touched(supports, grid, step);
    for (std::size_t l = 0; l < supports.lines.size(); ++l)
      apply_line(supports, supports.lines[l], supports.folds.lines[l], grid, step);
    reflect_velocities(grid);
  }

  void move_held_points(Solid &solid, const double dt)
  {
    Supports &supports = solid.supports;
    Points &points = solid.points;
    Loads &loads = solid.loads;
    const double t = solid.time;
    for (Support &support : supports.all)
      support.displacement = support.motion.at(support.middle, support.middle, t + dt);
    unsigned later = 0; // a point in two grips goes with the last
    for (std::size_t g = supports.grips.size(); g-- > 0;)
    {
      const Grip &grip = supports.grips[g];
      Support &support = supports.all[grip.support];
      const Point u = support.displacement;
      const Point v = (u - support.motion.at(support.middle, support.middle, t)) / dt;
      const Point load = g < loads.on_grips.size() ? loads.on_grips[g] : Point(0., 0.);
      loads.work += dt * load.dot(v), loads.work_done += std::abs(dt * load.dot(v));
      Account account{v, dt, -dt * load, -dt * load.dot(v)};
      for (std::size_t p = points.active; p < points.size(); ++p)
        if ((points.regions[p] & (1u << grip.region)) && !(points.regions[p] & later))
        {
          account.add_reaction(points, p, loads.acceleration);
          const Point X = solid.fraction.initial(points, p);
          points.x[p] = X[0] + u[0], points.y[p] = X[1] + u[1];
          points.vx[p] = v[0], points.vy[p] = v[1];
        }
      later |= 1u << grip.region;
      support.impulse += account.impulse, support.call_impulse += account.impulse;
      supports.work += account.work, supports.work_done += std::abs(account.work);
      for (auto &outline : solid.tracers.outlines)
        for (Tracer &tracer : outline)
          if (tracer.grip == static_cast<int>(g))
            tracer.x = tracer.X + u;
    }
    move_driven_points(supports, points);
    move_turning_edges(supports, solid.tracers, t + dt);
  }
} // namespace solid
