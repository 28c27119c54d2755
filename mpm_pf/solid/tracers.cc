#include "solid/tracers.h"
#include "solid/mirrors.h"

#include "scene/geometry.h"

namespace solid
{
  Tracers make_tracers(const std::vector<scene::Body> &bodies, const scene::Domain &domain,
                       const double spacing)
  {
    Tracers tracers;
    for (const scene::Polyline &line : scene::outline(bodies, domain, spacing))
    {
      tracers.outlines.emplace_back();
      for (const Point &X : line)
        tracers.outlines.back().push_back({X, X, 0, -1, 0});
    }
    return tracers;
  }

  namespace
  {
    // As transferred_velocity() beside a symmetry side, out of the way of the others.
    __attribute__((noinline)) Point transferred_by_images(const Grid &grid, const Stencil &s)
    {
      Point brought = Point::Zero(), pushed = Point::Zero();
      double weight = 0., mass = 0.;
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
        {
          const Image at = image_of(grid, s.i - 1 + a, s.j - 1 + b);
          if (at.node < 0 || grid.mass[at.node] <= 0.)
            continue;
          const double w = s.x.w[a] * s.y.w[b], node_mass = at.whole * grid.mass[at.node];
          const Velocity &v = grid.velocity[at.node];
          const Point momentum = at.whole * at.apply(grid.nodes[at.node].momentum());
          brought += w / node_mass * momentum;
          pushed += w * (node_mass * at.apply({v.x, v.y}) - momentum);
          weight += w, mass += w * node_mass;
        }
      return weight > 1e-9 ? Point(brought / weight + pushed / mass) : Point(0., 0.);
    }
  } // namespace

  Point transferred_velocity(const Interpolation &at, const Point &x)
  {
    const Grid &grid = at.grid;
    const int i = grid.nearest(x[0], 0), j = grid.nearest(x[1], 1);
    if (!grid.has(i - 1, j - 1) || !grid.has(i + 1, j + 1) || !grid.has(i - 1, j + 1) ||
        !grid.has(i + 1, j - 1) || !grid.has(i, j))
      return Point::Zero();
    const Stencil s = stencil(at, x);
    if (near_mirror(grid, s.i, s.j, 1))
      return transferred_by_images(grid, s);
    Point brought = Point::Zero(), pushed = Point::Zero();
    double weight = 0., mass = 0.;
    for (int b = 0; b < 3; ++b)
      for (int a = 0; a < 3; ++a)
      {
        const std::ptrdiff_t n = grid.at(s.i - 1 + a, s.j - 1 + b);
        if (grid.mass[n] <= 0.)
          continue;
        const double w = s.x.w[a] * s.y.w[b];
        const Point momentum = grid.nodes[n].momentum();
        brought += w / grid.mass[n] * momentum;
        pushed += w * (grid.mass[n] * Point(grid.velocity[n].x, grid.velocity[n].y) - momentum);
        weight += w, mass += w * grid.mass[n];
      }
    return weight > 1e-9 ? Point(brought / weight + pushed / mass) : Point(0., 0.);
  }

  void move(Tracers &tracers, const Interpolation &at, const double dt)
  {
    for (auto &outline : tracers.outlines)
      for (Tracer &tracer : outline)
        if (tracer.grip < 0)
          tracer.x += dt * transferred_velocity(at, tracer.x);
  }

  void refine(Tracers &tracers, const double longest)
  {
    for (auto &outline : tracers.outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
      {
        const Tracer &a = outline[k], &b = outline[(k + 1) % outline.size()];
        if ((b.x - a.x).squaredNorm() <= longest * longest)
          continue;
        const auto [X, x] = on_chord(outline, k, 0.5);
        const Tracer middle{X, x, a.lines & b.lines, a.grip == b.grip ? a.grip : -1, a.loads};
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
      }
  }
} // namespace solid
