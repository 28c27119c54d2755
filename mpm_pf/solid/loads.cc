#include "solid/loads.h"

#include <algorithm>
#include <string>

#include "scene/geometry.h"
#include "scene/reader.h"
#include "solid/body.h"
#include "solid/mirrors.h"

namespace solid
{
  namespace
  {
    // Tracers where a load begins or ends inside a chord, found by bisection. The very ends of a
    // chord are left out: an edge that meets another at a corner belongs to it within tolerance.
    template <typename Loaded>
    void split_chords(std::vector<Tracer> &outline, Loaded &&loaded)
    {
      constexpr double samples[] = {1e-3, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1. - 1e-3};
      std::vector<Tracer> split;
      for (std::size_t k = 0; k < outline.size(); ++k)
      {
        split.push_back(outline[k]);
        const auto inside = [&](const double s) { return loaded(on_chord(outline, k, s)[0]); };
        for (std::size_t i = 0; i + 1 < std::size(samples); ++i)
        {
          double low = samples[i], high = samples[i + 1];
          const bool first = inside(low);
          if (first == inside(high))
            continue;
          for (int halving = 0; halving < 50; ++halving)
          {
            const double middle = 0.5 * (low + high);
            (inside(middle) == first ? low : high) = middle;
          }
          const auto [X, x] = on_chord(outline, k, low);
          const Tracer &a = outline[k], &b = outline[(k + 1) % outline.size()];
          split.push_back({X, x, a.lines & b.lines, a.grip == b.grip ? a.grip : -1, a.loads});
        }
      }
      outline = std::move(split);
    }
  } // namespace

  Loads make_loads(const scene::Scene &scene, Tracers &tracers)
  {
    Loads loads;
    const scene::Box box = scene::bounding_box(scene.bodies);
    const double tolerance = place_tolerance(box, scene.domain.spacing()[0]);
    for (const scene::Traction &asked : scene.tractions)
    {
      const std::size_t index = loads.tractions.size();
      const std::string where = asked.place.file + ":" + std::to_string(asked.place.line) +
                                ": traction \"" + asked.name + "\" ";
      if (index >= 32)
        throw scene::BadScene(where + "is the 33rd traction; at most 32 are possible");
      bool any = false;
      const auto loaded = [&](const Point &X)
      { return scene::contains(asked.where, box, X, tolerance); };
      for (auto &outline : tracers.outlines)
      {
        split_chords(outline, loaded);
        for (std::size_t k = 0; k < outline.size(); ++k)
          if (loaded(on_chord(outline, k, 0.5)[0]))
            outline[k].loads |= 1u << index, any = true;
      }
      if (!any)
        throw scene::BadScene(where + "touches no straight piece of the outline; name an edge or a "
                                      "segment on it");
      Load load{
          asked.name, {scene::Function(asked.traction[0]), scene::Function(asked.traction[1])}, {}};
      if (asked.pressure)
        load.pressure.emplace(*asked.pressure);
      loads.tractions.push_back(std::move(load));
    }
    if (scene.body_force)
      loads.body_force.emplace(
          std::array<scene::Function, 2>{scene::Function(scene.body_force->acceleration[0]),
                                         scene::Function(scene.body_force->acceleration[1])});
    return loads;
  }

  void evaluate_body_force(Loads &loads, const Points &points, const Fraction &fraction,
                           const double t)
  {
    if (!loads.body_force)
      return;
    const auto &[bx, by] = *loads.body_force;
    Acceleration &acceleration = loads.acceleration;
    if (!bx.depends_on_position() && !by.depends_on_position())
    {
      const scene::Argument at{Point::Zero(), Point::Zero(), t};
      acceleration.uniform = {loads.true_mass * bx(at), loads.true_mass * by(at)};
      return;
    }
    acceleration.x.resize(points.size()), acceleration.y.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      const scene::Argument at{fraction.initial(points, p), {points.x[p], points.y[p]}, t};
      acceleration.x[p] = loads.true_mass * bx(at), acceleration.y[p] = loads.true_mass * by(at);
    }
  }

  namespace
  {
    // On a whole chord, if the load were everywhere as it is at `at`.
    Point force_on(const Load &load, const Point &chord, const scene::Argument &at)
    {
      if (load.pressure)
        return (*load.pressure)(at)*Point(-chord[1], chord[0]);
      return chord.norm() * Point(load.traction[0](at), load.traction[1](at));
    }

    // False if no node there has mass.
    bool spread(Solid &solid, const Point &x, const Point &force)
    {
      Loads &loads = solid.loads;
      Grid &grid = solid.grid;
      const Stencil s = stencil(solid.interpolation(), x);
      double share[9], sum = 0.;
      std::array<Image, 9> images;
      const bool straight = !near_mirror(grid, s.i, s.j, 1);
      for (int k = 0; k < 9; ++k)
      {
        const int i = s.i - 1 + k % 3, j = s.j - 1 + k / 3;
        images[k] = straight ? Image{grid.at(i, j), {1., 1.}, 1.} : image_of(grid, i, j);
        const std::ptrdiff_t n = images[k].node;
        share[k] = grid.mass[n] > 0. ? s.x.w[k % 3] * s.y.w[k / 3] * loads.shares[n] : 0.;
        sum += share[k];
      }
      for (int k = 0; k < 9 && sum > 0.; ++k)
      {
        const std::ptrdiff_t n = images[k].node;
        const Point part = images[k].apply(share[k] / sum * force);
        grid.nodes[n].motion += Quad{0., part[0], 0., part[1]};
        loads.nodal_forces.push_back({n, part});
      }
      return sum > 0.;
    }

    void put_on_grip(Loads &loads, const int grip, const Point &force)
    {
      const auto count = static_cast<std::size_t>(grip) + 1;
      loads.on_grips.resize(std::max(loads.on_grips.size(), count), Point(0., 0.));
      loads.on_grips[grip] += force;
    }
  } // namespace

  void apply_tractions(Solid &solid)
  {
    Loads &loads = solid.loads;
    Grid &grid = solid.grid;
    loads.nodal_forces.clear(), loads.parted.reset();
    std::fill(loads.on_grips.begin(), loads.on_grips.end(), Point(0., 0.));
    if (loads.tractions.empty())
      return;
    loads.shares.measure(solid.tracers, solid.points, solid.interpolation(),
                         1. / solid.material.density);
    for (const auto &outline : solid.tracers.outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
      {
        if (outline[k].loads == 0)
          continue;
        const Tracer &next = outline[(k + 1) % outline.size()];
        const Point chord = next.x - outline[k].x;
        const int grip = std::max(outline[k].grip, next.grip); // of one end at least, or -1
        const bool gripped = grip >= 0 && outline[k].grip == next.grip;
        for (const double s : chord_gauss_points)
        {
          const auto [X, x] = on_chord(outline, k, s);
          const bool seen = grid.surrounds(x);
          if (!seen && grip < 0)
          {
            loads.parted = X;
            continue;
          }
          Point force = Point::Zero();
          for (std::size_t l = 0; l < loads.tractions.size(); ++l)
            if (outline[k].loads & (1u << l))
              force += 0.5 * force_on(loads.tractions[l], chord, {X, x, solid.time});
          const bool nodes_take = seen && !gripped && spread(solid, x, force);
          if (grip >= 0 && !nodes_take)
            put_on_grip(loads, grip, force);
        }
      }
  }

  void add_traction_work(Loads &loads, const Grid &grid, const double dt)
  {
    for (const Loads::NodalForce &push : loads.nodal_forces)
    {
      const Velocity &v = grid.velocity[push.node];
      const double mass = grid.mass[push.node];
      const Point after(v.x, v.y);
      const Point before = mass > 0. ? Point(grid.nodes[push.node].momentum() / mass) : after;
      const double work = 0.5 * dt * push.force.dot(before + after);
      loads.work += work, loads.work_done += std::abs(work);
    }
  }

  void add_body_force_work(Loads &loads, const Points &points, const double dt)
  {
    if (!loads.body_force)
      return;
    const Acceleration &a = loads.acceleration;
    double work = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      work += points.mass[p] * (points.vx[p] * (a.x.empty() ? a.uniform[0] : a.x[p]) +
                                points.vy[p] * (a.y.empty() ? a.uniform[1] : a.y[p]));
    loads.work += dt * work, loads.work_done += std::abs(dt * work);
  }
} // namespace solid
