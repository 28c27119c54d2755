#include "solid/walls.h"

#include <algorithm>
#include <cmath>

#include "solid/energy.h"

namespace solid
{
  namespace
  {
    using scene::Edge;

    // Contact where the wall's row holds this part of the mass that material without a gap would
    // give it. Half of it would be met a quarter of a cell too early, a fifth of the work lost in
    // closing that gap; all of it would never be met by points that lie unevenly.
    constexpr double touching = 0.9;
    // What is at a wall is let go only where this part is left: a grip may pull, and what lies
    // unevenly does not come and go with every step.
    constexpr double parting = 0.5;

    int axis_of(const Edge side)
    {
      return side == Edge::left || side == Edge::right ? 0 : 1;
    }

    // Integral of the quadratic B-spline up to s; for the other shapes it is near enough, since it
    // only sets the scale of a gap.
    double spline_integral(const double s)
    {
      const double a = std::min(std::max(s, -1.5), 1.5), h = 1.5 - std::abs(a);
      if (std::abs(a) <= 0.5)
        return 0.5 + 0.75 * a - a * a * a / 3.;
      return a < 0. ? h * h * h / 6. : 1. - h * h * h / 6.;
    }

    // Masses of the carrier and of the first inner row, if material reached to the line everywhere.
    struct Full
    {
      double carrier = 0., master = 0.;
    };

    Full full_masses(const Fold &fold, const double lower, const double dx)
    {
      const auto distance = [&](const int row) { return (lower + row * dx - fold.position) / dx; };
      const double reach = distance(fold.master);
      Full full;
      full.master = spline_integral(fold.side * reach);
      for (int behind = 1; behind <= 3; ++behind)
      {
        const double s = distance(fold.master - behind * fold.side);
        const double inside = spline_integral(fold.side * s), share = 1. - s / reach;
        full.carrier += share * inside, full.master += (1. - share) * inside;
      }
      return full;
    }

    HeldLine line_of(const scene::Domain &domain, const scene::Wall &wall, const int support)
    {
      HeldLine line;
      line.support = support, line.contact = true;
      line.axis = axis_of(wall.side);
      line.side = wall.side == Edge::left || wall.side == Edge::bottom ? 1 : -1;
      line.initial = line.position = (line.side > 0 ? domain.lower : domain.upper())[line.axis];
      line.from = line.lower = domain.lower[1 - line.axis];
      line.to = line.upper = domain.upper()[1 - line.axis];
      line.held = {true, true};
      if (wall.grip == scene::WallGrip::slip)
        line.held[1 - line.axis] = false;
      line.touched.assign(domain.cells[1 - line.axis] + 1 + 2 * HeldLine::margin, 0);
      line.stuck = line.touched;
      return line;
    }
  } // namespace

  std::string wall_name(const Edge side)
  {
    constexpr std::array<const char *, 4> names{"left", "right", "bottom", "top"};
    return std::string("wall ") + names[static_cast<std::size_t>(side)];
  }

  void add_walls(Supports &supports, const scene::Scene &scene)
  {
    for (const scene::Wall &wall : scene.walls)
    {
      Support support;
      support.name = wall_name(wall.side), support.place = wall.place;
      support.motion.driven.emplace();
      const HeldLine line = line_of(scene.domain, wall, static_cast<int>(supports.all.size()));
      support.motion.driven->holds = line.held;
      support.middle[line.axis] = line.initial;
      support.middle[1 - line.axis] = 0.5 * (line.from + line.to);
      supports.all.push_back(std::move(support));
      supports.lines.push_back(line);
    }
  }

  void set_wall_motions(Solid &solid, const std::vector<WallMotion> &walls, const double dt)
  {
    for (const WallMotion &wall : walls)
    {
      const std::string name = wall_name(wall.side);
      bool found = false;
      for (const HeldLine &line : solid.supports.lines)
        if (line.contact && solid.supports.all[line.support].name == name)
        {
          Driven &driven = *solid.supports.all[line.support].motion.driven;
          driven.since = solid.time;
          driven.velocity[line.axis] = wall.velocity;
          driven.displacement[line.axis] = wall.position - wall.velocity * dt - line.initial;
          found = true;
        }
      if (!found)
        throw std::out_of_range("the scene has no wall on the side of \"" + name + "\"");
    }
  }

  bool touches(const HeldLine &line, const Fold &fold, const Grid &grid, const WallNode &node)
  {
    const auto &[i, j, n, v, sticks] = node;
    const int inner_i = i + (line.axis == 0 ? line.side : 0);
    const int inner_j = j + (line.axis == 1 ? line.side : 0);
    if (!grid.has(inner_i, inner_j))
      return true;
    const Full full = full_masses(fold, grid.lower[line.axis], grid.dx);
    const double carrier = grid.mass[n];
    const double master = grid.mass[grid.at(inner_i, inner_j)];
    if (carrier * full.master < (sticks ? parting : touching) * master * full.carrier)
      return false;
    const Velocity &now = grid.velocity[n];
    const double along = line.axis == 0 ? now.x : now.y;
    return line.held[1 - line.axis] || (along - v[line.axis]) * line.side < 0.;
  }

  void bound_by_walls(const Supports &supports, const double t, Point &lower, Point &upper)
  {
    for (const HeldLine &line : supports.lines)
      if (line.contact)
      {
        const Point zero = Point::Zero();
        const double now =
            line.initial + supports.all[line.support].motion.at(zero, zero, t)[line.axis];
        if (line.side > 0)
          lower[line.axis] = std::max(lower[line.axis], now);
        else
          upper[line.axis] = std::min(upper[line.axis], now);
      }
  }

  void stop_at_walls(Solid &solid, const double t)
  {
    Points &points = solid.points;
    for (const HeldLine &line : solid.supports.lines)
    {
      if (!line.contact)
        continue;
      Support &support = solid.supports.all[line.support];
      const double v = support.motion.driven->velocity[line.axis];
      const double wall = line.initial + support.motion.at({0., 0.}, {0., 0.}, t)[line.axis];
      const double before = wall + 1e-6 * solid.grid.dx * line.side;
      Array<double> &x = line.axis == 0 ? points.x : points.y;
      Array<double> &velocity = line.axis == 0 ? points.vx : points.vy;
      for (std::size_t p = 0; p < points.active; ++p)
        if ((x[p] - wall) * line.side < 0.)
        {
          const double impulse = points.mass[p] * (v - velocity[p]);
          const double work = impulse * v;
          x[p] = before, velocity[p] = v;
          support.impulse[line.axis] += impulse, support.call_impulse[line.axis] += impulse;
          solid.supports.work += work, solid.supports.work_done += std::abs(work);
        }
    }
  }

  void unfold(const Supports &supports, const scene::Domain &domain, const Grid &grid,
              NodalVelocity &mean)
  {
    for (const HeldLine &line : supports.lines)
    {
      if (line.support < 0)
        continue;
      const Fold fold = fold_at(line.position, line.side, grid.lower[line.axis], grid.dx);
      const auto at = [&](const int row) { return grid.lower[line.axis] + row * grid.dx; };
      const double share =
          1. - (at(fold.carrier()) - fold.position) / (at(fold.master) - fold.position);
      for_nodes_along(line, grid, fold.carrier(), {1., 1.},
                      [&](const int i, const int j, std::ptrdiff_t)
                      {
                        const int a = i + (line.axis == 0 ? line.side : 0);
                        const int b = j + (line.axis == 1 ? line.side : 0);
                        const auto inside = [&](const int x, const int y) {
                          return x >= 0 && y >= 0 && x <= domain.cells[0] && y <= domain.cells[1];
                        };
                        if (!inside(i, j) || !inside(a, b))
                          return;
                        const std::size_t row = domain.cells[0] + 1;
                        const std::size_t carrier = j * row + i, master = b * row + a;
                        if (mean.mass[carrier] > 0. && mean.mass[master] > 0.)
                        {
                          mean.x[carrier] += (1. - share) * (mean.x[master] - mean.x[carrier]);
                          mean.y[carrier] += (1. - share) * (mean.y[master] - mean.y[carrier]);
                        }
                      });
    }
  }

  bool has_walls(const Supports &supports)
  {
    return std::any_of(supports.lines.begin(), supports.lines.end(),
                       [](const HeldLine &line) { return line.contact; });
  }

  void add_wall_balance(Solid &solid, const Point &momentum_before)
  {
    Point impulse = Point::Zero();
    for (const HeldLine &line : solid.supports.lines)
      if (line.contact)
        impulse[line.axis] += std::abs(solid.supports.all[line.support].call_impulse[line.axis]);
    const Point change = momentum(solid) - momentum_before;
    for (int axis = 0; axis < 2; ++axis)
      if (impulse[axis] > 0.)
      {
        solid.wall_balance.change[axis] += std::abs(change[axis]);
        solid.wall_balance.impulse[axis] += impulse[axis];
      }
  }

  QuasiStatic quasi_static(const Solid &solid, const WallLoading &loading)
  {
    QuasiStatic found;
    const double strength = solid.material.yield_stress.value_or(0.01 * solid.material.young);
    found.inertia_travel =
        loading.arm * solid.material.density * loading.speed * loading.speed / strength;
    for (int axis = 0; axis < 2; ++axis)
    {
      double sum = 0., size = 0.;
      int count = 0;
      for (const HeldLine &line : solid.supports.lines)
        if (line.contact && line.axis == axis)
        {
          const double force = reaction(solid, solid.supports.all[line.support].name).force[axis];
          sum += force, size += std::abs(force), ++count;
        }
      if (count == 2 && size > 0.)
        found.force_imbalance = std::max(found.force_imbalance, 2. * std::abs(sum) / size);
      const WallBalance &balance = solid.wall_balance;
      if (count == 1 && balance.impulse[axis] > 0.)
        found.momentum_to_force =
            std::max(found.momentum_to_force, balance.change[axis] / balance.impulse[axis]);
    }
    const double internal = elastic_energy(solid) + solid.energy.dissipated;
    found.kinetic_to_internal = internal > 0. ? kinetic_energy(solid) / internal : 0.;
    return found;
  }
} // namespace solid
