#include "medium/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "medium/crossing.h"
#include "medium/numerical_error.h"

namespace medium
{
  namespace
  {
    std::string where(const scene::Wall &wall)
    {
      return wall.place.file.empty()
                 ? std::string{}
                 : wall.place.file + ":" + std::to_string(wall.place.line) + ": ";
    }

    /// Inward travel a time `t` after a start from rest, without its limit.
    double free_travel(double speed, double ramp, double t)
    {
      if (t <= 0.)
        return 0.;
      if (t >= ramp)
        return speed * (t - 0.5 * ramp);
      const double s = t / ramp;
      return speed * ramp * s * s * s * (1. - 0.5 * s);
    }

    double travel_at(const Wall &wall, double time)
    {
      const scene::Wall &asked = wall.asked;
      double free = 0.;
      const double contact_ramp = asked.contact_ramp.value_or(0.);
      if (wall.touched && contact_ramp > 0. && (wall.started || !asked.start_time))
        free = wall.travel_at_touch +
               free_travel(asked.speed, contact_ramp,
                           time - std::max(*wall.touched, wall.started.value_or(*wall.touched)));
      else if (wall.started)
        free = free_travel(asked.speed, asked.ramp.value_or(0.), time - *wall.started);
      return std::min(free, asked.travel);
    }

    /// From a wall to the opposite one, or to the opposite side of the domain.
    double span(const Wall &wall, const Walls &walls, const Mesh &mesh)
    {
      const int axis = wall.axis();
      double opposite =
          mesh.lower[axis] + (wall.inward() > 0 ? (mesh.nodes[axis] - 1) * mesh.spacing[axis] : 0.);
      for (const Wall &other : walls.walls)
        if (other.axis() == axis && other.side != wall.side)
          opposite = other.position;
      return std::abs(opposite - wall.position);
    }

    void check(const scene::Wall &asked, const Walls &walls, const Mesh &mesh)
    {
      if (walls.at(asked.side))
        throw std::invalid_argument(where(asked) +
                                    "wall.side: a second wall on the same side; give "
                                    "each side one wall at most");
      const Boundary boundary = mesh.side(asked.side);
      if (boundary == Boundary::periodic || boundary == Boundary::fixed)
        throw std::invalid_argument(where(asked) +
                                    "wall.side: a wall can only stand on a no_flux or "
                                    "symmetry side of the domain");
    }
  } // namespace

  const Wall *Walls::at(Edge side) const
  {
    for (const Wall &wall : walls)
      if (wall.side == side)
        return &wall;
    return nullptr;
  }

  bool Walls::moving() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const Wall &w) { return w.velocity != 0.; });
  }

  Walls make_walls(const std::vector<scene::Wall> &asked, const Mesh &mesh)
  {
    Walls made;
    double travel[2] = {0., 0.};
    for (const scene::Wall &one : asked)
    {
      check(one, made, mesh);
      Wall wall{};
      wall.asked = one, wall.side = one.side, wall.grip = one.grip;
      wall.start_distance = one.start_time ? -1. : one.start_distance.value_or(0.);
      const int axis = wall.axis();
      wall.origin =
          mesh.lower[axis] + (wall.inward() > 0 ? 0. : (mesh.nodes[axis] - 1) * mesh.spacing[axis]);
      wall.position = wall.origin;
      travel[axis] += one.travel;
      if (travel[axis] > (mesh.nodes[axis] - 1 - scene::cells_between_walls) * mesh.spacing[axis])
        throw std::invalid_argument(where(one) +
                                    "wall.travel: the walls would meet; leave at least "
                                    "five cells between them");
      made.walls.push_back(wall);
    }
    return made;
  }

  std::optional<double> gap_to_front(const Wall &wall, const Cuts &cuts, const Field<double> &phi,
                                     const Mesh &mesh, double reach)
  {
    const int axis = wall.axis(), inward = wall.inward(), count = mesh.nodes[axis];
    const auto &cut = cuts.at(wall.side);
    const int last = cut ? cut->last : (inward > 0 ? 0 : count - 1);
    const double gap = cut ? cut->gap : 0., h = mesh.spacing[axis];
    const auto at = [&](int k, int n)
    { return axis == 0 ? phi(last + inward * k, n) : phi(n, last + inward * k); };
    // An edge along a line of nodes leaves phi = 0 there but for rounding: no front stands on it.
    constexpr double least = 1e-6;
    const int first = cuts.first(1 - axis), end = cuts.end(1 - axis, mesh.nodes[1 - axis]);
    const int behind = inward > 0 ? cuts.end(axis, count) - 1 : cuts.first(axis);
    const int deepest =
        static_cast<int>(std::min<double>(inward * (behind - last), std::ceil(reach / h) + 1.));
    for (int k = 0; k <= deepest; ++k)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (int n = first; n < end; ++n)
      {
        if (at(k, n) <= least)
          continue;
        if (k == 0)
        {
          // phi = a + b y^2 between the wall and its last line, y from the wall.
          const double b = (at(1, n) - at(0, n)) / (1. + 2. * gap), a = at(0, n) - b * gap * gap;
          nearest = std::min(nearest, a >= 0. ? 0. : std::sqrt(-a / b));
          continue;
        }
        const double here = straightened(at(k, n));
        const double before = straightened(std::min(0., at(k - 1, n)));
        nearest = std::min(nearest, gap + k - here / (here - before));
      }
      if (nearest * h <= reach)
        return std::max(0., nearest) * h;
    }
    return std::nullopt;
  }

  void start_walls(Walls &walls, double time)
  {
    for (Wall &wall : walls.walls)
      if (!wall.started && wall.asked.start_time && time >= *wall.asked.start_time)
        wall.started = wall.asked.start_time;
  }

  void start_walls(Walls &walls, const Field<double> &phi, const Mesh &mesh, double time,
                   const Contact counted)
  {
    start_walls(walls, time);
    for (Wall &wall : walls.walls)
    {
      const bool by_time = wall.start_distance < 0.;
      if (wall.touched || (by_time && !wall.started))
        continue;
      const double reach = std::max(wall.start_distance, mesh.spacing[wall.axis()]);
      const auto gap = gap_to_front(wall, walls.cuts, phi, mesh, reach);
      if (!gap)
        continue;
      if (!wall.started && *gap > wall.start_distance)
        continue; // nearer than a cell, not as near as asked
      if (!wall.started)
        wall.started = time;
      if (*gap > 0. || counted == Contact::push)
        continue;
      record_contact(wall, walls, mesh, time);
    }
  }

  void record_contact(Wall &wall, const Walls &walls, const Mesh &mesh, double time)
  {
    wall.touched = time;
    if (!wall.started && wall.start_distance >= 0.)
      wall.started = time; // nearer it will not come
    wall.travel_at_touch = wall.travel;
    wall.span_at_touch = span(wall, walls, mesh);
  }

  void move(Walls &walls, double time, double dt, const Mesh &mesh)
  {
    for (Wall &wall : walls.walls)
    {
      const double before = wall.travel, h = mesh.spacing[wall.axis()];
      wall.travel = std::max(before, travel_at(wall, time + dt));
      if (wall.travel - before > 0.5 * h)
      {
        std::ostringstream text;
        text << "at time " << time << " a wall crosses " << (wall.travel - before) / h
             << " cells in one step of " << dt
             << "; at most half a cell is allowed: shorten the step";
        throw NumericalError(text.str());
      }
      wall.position = wall.origin + wall.inward() * wall.travel;
      wall.velocity = wall.inward() * (wall.travel - before) / dt;
    }
  }

  double step_limit(const Walls &walls, const Mesh &mesh, double fraction)
  {
    double limit = std::numeric_limits<double>::infinity();
    for (const Wall &wall : walls.walls)
      // one that has not started may do so within the step
      if (wall.asked.speed > 0. && wall.travel < wall.asked.travel)
        limit = std::min(limit, fraction * mesh.spacing[wall.axis()] / wall.asked.speed);
    return limit;
  }

  namespace
  {
    /// Along one axis, if each wall had gone inwards as far as `travel(wall)`; 0 before a touch.
    template <class Travel>
    double compression_along(const Walls &walls, const int axis, Travel &&travel)
    {
      double pressed = 0., span = 0.;
      for (const Wall &wall : walls.walls)
        if (wall.axis() == axis && wall.touched)
        {
          pressed += travel(wall) - wall.travel_at_touch;
          span = std::max(span, wall.span_at_touch);
        }
      return span > 0. ? pressed / span : 0.;
    }
  } // namespace

  double time_to_compression(const Walls &walls, const double time, const double wanted,
                             const double longest)
  {
    double soonest = longest;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto after_a_time = [&](const double t)
      {
        return compression_along(walls, axis,
                                 [&](const Wall &wall)
                                 { return std::max(wall.travel, travel_at(wall, time + t)); });
      };
      if (after_a_time(0.) >= wanted * (1. - 1e-9) || after_a_time(soonest) < wanted)
        continue;
      double before = 0., after = soonest; // of the moment, where it is not reached and where it is
      while (after - before > 1e-9 * soonest)
      {
        const double middle = 0.5 * (before + after);
        (after_a_time(middle) < wanted ? before : after) = middle;
      }
      soonest = after;
    }
    return soonest;
  }

  std::size_t bytes(const Walls &walls)
  {
    return sizeof(walls) + walls.walls.capacity() * sizeof(Wall);
  }

  double compression(const Walls &walls)
  {
    const auto present = [](const Wall &wall) { return wall.travel; };
    return std::max(
        {0., compression_along(walls, 0, present), compression_along(walls, 1, present)});
  }
} // namespace medium
