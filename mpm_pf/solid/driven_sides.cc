// Nodes in and around driven boxes, one component of velocity at a time.
//
// Nodes well inside take the prescribed velocity V(x). Those around a side of the box towards other
// material are shared with it. Were they held or left free as a whole, the side would sit wherever
// nodes happen to lie, up to a cell and a half off; instead the free material sees functions that
// vanish on the side itself. With s the distance from the side, positive in the free material, in
// cells along the row or the column of nodes that its normal is closer to, a node i with s_i < 1/2
// is tied to the first node M in its row or column with s_M >= 1/2,
//   v_i = V(x_i) + r_i w_M,   v_M = V(x_M) + w_M,   r_i = s_i/s_M,
// so that w is linear and zero at s = 0, as near a held line (shape_functions.h), but for slanted
// sides too. By d'Alembert's principle with masses m and momenta p of the free material alone
//   w_M = (p_M - m_M V(x_M) + sum r_i (p_i - m_i V(x_i)))/(m_M + sum r_i^2 m_i).
// The support gives the free material m_i v_i - p_i at each node, and v_i times that of work.
#include <limits>

#include "scene/geometry.h"
#include "solid/supports.h"

namespace solid
{
  namespace
  {
    // Cells from the side from which on a node is free; half-way, as fold_at does.
    constexpr double beside = 0.5 + 1e-9;
    // Beyond sides that are not open, another body that comes close sticks to nodes of which at
    // least this share is driven: those within 0.6 cells.
    constexpr double driven_share = 0.11, closed_reach = 0.6;

    struct Side
    {
      double distance = -std::numeric_limits<double>::infinity(); // unless a side is open
      std::array<int, 2> step{0, 0};                              // outwards along row or column
    };

    // The nearest open side as seen from a node.
    Side side_of(const DrivenRegion &region, const Cover &cover, const double dx)
    {
      const Point X = cover.origin / cover.weight;
      Side side;
      Point beyond(side.distance, side.distance), outwards(0., 0.);
      for (int axis = 0; axis < 2; ++axis)
        for (const int upper : {0, 1})
        {
          const double out =
              upper ? X[axis] - region.box.upper[axis] : region.box.lower[axis] - X[axis];
          if (region.open[axis][upper] && out > beyond[axis])
            beyond[axis] = out, outwards[axis] = upper ? 1. : -1.;
        }
      if (outwards.isZero())
        return side;
      Point direction = beyond[0] > beyond[1] ? Point(1., 0.) : Point(0., 1.);
      double distance = beyond.maxCoeff();
      if (beyond.minCoeff() > 0.)
        distance = beyond.norm(), direction = beyond / distance;
      const Point gradient =
          cover.slope.transpose() / cover.weight * direction.cwiseProduct(outwards);
      const int axis = std::abs(gradient[0]) > std::abs(gradient[1]) ? 0 : 1;
      side.distance = distance / (std::abs(gradient[axis]) * dx);
      side.step[axis] = gradient[axis] > 0. ? 1 : -1;
      return side;
    }

    // Is what is at a node no more than closed_reach beyond the sides that are not open?
    bool between_closed_sides(const DrivenRegion &region, const Cover &cover, const double dx)
    {
      const Point X = cover.origin / cover.weight;
      for (int axis = 0; axis < 2; ++axis)
        for (const int upper : {0, 1})
        {
          const double out =
              upper ? X[axis] - region.box.upper[axis] : region.box.lower[axis] - X[axis];
          if (!region.open[axis][upper] && out > closed_reach * dx)
            return false;
        }
      return true;
    }

    // What the region that a node lies deepest in, or nearest to, makes of it.
    struct Held
    {
      const DrivenRegion *region = nullptr;
      Side side;
      double prescribed = 0., mass = 0., excess = 0.; // the free material's, beyond `prescribed`
      std::ptrdiff_t master = -1;                     // the node that it is tied to
      double ratio = 0.;
      double inertia = 0., pull = 0.; // of all that a free node moves, itself included
    };

    Held held_at(const Supports &supports, const Grid &grid, const std::ptrdiff_t n, const int c)
    {
      Held held;
      const DrivenPart &part = supports.driven_parts[n][c];
      const bool shared = part.mass >= driven_share * grid.mass[n];
      for (const DrivenRegion &region : supports.driven)
        if (const Cover &cover = region.covers[n];
            cover.weight > 0. && supports.all[region.support].motion.holds(c))
        {
          const Side side = side_of(region, cover, grid.dx);
          if (!shared && side.distance < beside &&
              (!std::isfinite(side.distance) || !between_closed_sides(region, cover, grid.dx)))
            continue;
          if (!held.region || side.distance < held.side.distance)
            held.region = &region, held.side = side,
            held.prescribed = cover.velocity[c] / cover.weight;
        }
      if (!held.region || !(grid.mass[n] > 0.))
        return {};
      constexpr double rounding = 1e-9;
      if (const double mass = grid.mass[n] - part.mass; mass > rounding * grid.mass[n])
      {
        const double v = c == 0 ? grid.velocity[n].x : grid.velocity[n].y;
        held.mass = mass;
        held.excess = grid.mass[n] * v - part.momentum - part.impulse - mass * held.prescribed;
      }
      return held;
    }

    // The node at (i, j) follows one in its row or column that is clear of the side, if any is.
    void tie_at(const Grid &grid, std::vector<Held> &all, const int i, const int j)
    {
      Held &held = all[grid.at(i, j)];
      for (int k = 1; k <= 3; ++k)
      {
        const int a = i + k * held.side.step[0], b = j + k * held.side.step[1];
        if (!grid.has(a, b))
          return;
        const std::ptrdiff_t m = grid.at(a, b);
        const Cover &cover = held.region->covers[m];
        if (!all[m].region || !(cover.weight > 0.))
          return;
        const double distance = side_of(*held.region, cover, grid.dx).distance;
        if (distance < beside)
          continue;
        held.master = m, held.ratio = held.side.distance / distance;
        return;
      }
    }

    // Beside two boxes at once a node's master follows another one in turn: the product vanishes on
    // both sides. The last one, or null if that does not move freely; and the product.
    std::pair<Held *, double> last_master(std::vector<Held> &all, const std::ptrdiff_t n)
    {
      Held *held = &all[n];
      double ratio = 1.;
      for (int k = 0; k < 3 && held->master >= 0; ++k)
        ratio *= held->ratio, held = &all[held->master];
      return {held->side.distance < beside ? nullptr : held, ratio};
    }

    struct HeldComponent
    {
      std::size_t node;
      int component;
      double velocity;
    };
    // As set_velocity() of supports.h, but what driven points bring is not the support's doing.
    void set(Supports &supports, Support *const support, Grid &grid, const HeldComponent &given)
    {
      const auto &[n, c, v] = given;
      const DrivenPart &part = supports.driven_parts[n][c];
      double &velocity = c == 0 ? grid.velocity[n].x : grid.velocity[n].y;
      const double mass = grid.mass[n] - part.mass;
      const double before = mass > 0. ? (grid.nodes[n].momentum()[c] - part.momentum) / mass : v;
      if (support)
      {
        const double impulse = mass * v - (grid.mass[n] * velocity - part.momentum - part.impulse);
        support->impulse[c] += impulse, support->call_impulse[c] += impulse;
        const double work = 0.5 * impulse * (v + before);
        supports.work += work, supports.work_done += std::abs(work);
      }
      if (!grid.change.empty())
        (c == 0 ? grid.change[n].x : grid.change[n].y) = v - before;
      grid.nodes[n].motion[2 * c] = grid.mass[n] * v;
      velocity = v;
    }
  } // namespace

  std::array<std::array<bool, 2>, 2> open_sides(const scene::Scene &scene,
                                                const scene::Support &asked)
  {
    const auto &box = std::get<scene::Box>(asked.where);
    const double dx = scene.domain.spacing()[0];
    const auto driven = [&](const scene::Support &other, const Point &x)
    {
      for (int c = 0; c < 2; ++c)
        if (asked.displacement[c] && !other.displacement[c])
          return false;
      const auto *const held = std::get_if<scene::Box>(&other.where);
      return held && (x - held->lower).minCoeff() > 0. && (held->upper - x).minCoeff() > 0.;
    };
    std::array<std::array<bool, 2>, 2> open{};
    constexpr int samples = 400;
    for (int axis = 0; axis < 2; ++axis)
      for (const int upper : {0, 1})
        for (int k = 0; k <= samples; ++k)
        {
          Point x = box.lower + k / double(samples) * (box.upper - box.lower);
          x[axis] = upper ? box.upper[axis] + 0.01 * dx : box.lower[axis] - 0.01 * dx;
          open[axis][upper] |=
              scene::signed_distance(scene.bodies, x) > 1e-6 * dx &&
              std::none_of(scene.supports.begin(), scene.supports.end(),
                           [&](const scene::Support &other) { return driven(other, x); });
        }
    return open;
  }

  void apply_driven_regions(Supports &supports, Grid &grid, const bool count_reaction)
  {
    for (int c = 0; c < 2; ++c)
    {
      std::vector<Held> all(grid.nodes.size());
      for_each_node(grid, [&](int, int, const std::ptrdiff_t n)
                    { all[n] = held_at(supports, grid, n, c); });
      for_each_node(grid,
                    [&](const int i, const int j, const std::ptrdiff_t n)
                    {
                      if (all[n].region && all[n].side.distance < beside)
                        tie_at(grid, all, i, j);
                    });
      for (std::size_t n = 0; n < all.size(); ++n)
        if (const auto [master, ratio] = last_master(all, n); master)
        {
          master->pull += ratio * all[n].excess;
          master->inertia += ratio * ratio * all[n].mass;
        }
      for (std::size_t n = 0; n < all.size(); ++n)
      {
        if (!all[n].region)
          continue;
        const auto [master, ratio] = last_master(all, n);
        const double w =
            master && master->inertia > 0. ? ratio * master->pull / master->inertia : 0.;
        set(supports, count_reaction ? &supports.all[all[n].region->support] : nullptr, grid,
            {n, c, all[n].prescribed + w});
      }
    }
  }
} // namespace solid
