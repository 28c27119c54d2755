// What points of driven boxes are prescribed, what they say about the nodes around them, and what
// it takes to move them.
//
// Their share of the nodes' masses, momenta and forces is known and is taken out of the momentum
// balance (driven_sides.cc), and they ride where they are told. So the support is charged by point,
// exactly: m (v - v_old) - dt m b of momentum and
// m (v^2 - v_old^2)/2 - dt m b.v + dt V sigma:C of work, with the prescribed velocity gradient C
// taken to the mid configuration as the strains are (stress.h), so that turning costs no work.
#include <Eigen/LU>

#include "scene/speed.h"
#include "solid/body.h"
#include "solid/mirrors.h"

namespace solid
{
  namespace
  {
    using Matrix = Eigen::Matrix2d;

    // A motion over a step around a point, to first order.
    struct AffineMotion
    {
      Point X, x;      // where the point started, and where it is at the step's start
      Point to;        // its displacement at the step's end
      Point velocity;  // over the step
      Matrix gradient; // of the velocity
      Matrix back;     // dX/dx at the step's start
    };

    // `h`: step of the differences.
    AffineMotion affine_around(const scene::Argument &at, const Motion &motion, const double dt,
                               const double h)
    {
      const auto &[X, x, t] = at;
      const Point from = motion.at(X, x, t), to = motion.at(X, x, t + dt), v = (to - from) / dt;
      const Matrix back = motion.gradient(X, x, t, h).inverse();
      const Matrix C = (motion.gradient(X, x, t + dt, h) * back - Matrix::Identity()) / dt;
      return {X, x, to, v, C, back};
    }

    // The region's motion to its point, where no region before it holds the component.
    void prescribe(Prescribed &point, const Motion &motion, const AffineMotion &near,
                   const int support)
    {
      for (int c = 0; c < 2; ++c)
        if (motion.holds(c) && point.support[c] < 0)
        {
          point.support[c] = support;
          point.velocity[c] = near.velocity[c], point.position[c] = near.X[c] + near.to[c];
          point.gradient.row(c) = near.gradient.row(c);
        }
    }

    // And to the nodes around, where nearer points count more; any weights are exact for affine
    // motions.
    void add_to_covers(DrivenRegion &region, const AffineMotion &near, const Grid &grid)
    {
      // To nodes that free material beside an open side may be tied to, else to its own.
      const auto &open = region.open;
      const int reach = open[0][0] || open[0][1] || open[1][0] || open[1][1] ? 3 : 1;
      const Point &x = near.x;
      const int i = grid.nearest(x[0], 0), j = grid.nearest(x[1], 1);
      for (int b = j - reach; b <= j + reach; ++b)
        for (int a = i - reach; a <= i + reach; ++a)
          if (grid.has(a, b))
          {
            const Point d = Point(grid.node_x(a), grid.node_y(b)) - x;
            const double q = 1. / (1. + d.squaredNorm() / (grid.dx * grid.dx)), w = q * q * q * q;
            Cover &cover = region.covers[grid.at(a, b)];
            cover.weight += w, cover.velocity += w * (near.velocity + near.gradient * d);
            cover.origin += w * (near.X + near.back * d), cover.slope += w * near.back;
          }
    }

    // C (I + dt C/2)^-1, whose symmetric part vanishes in a rigid rotation; stress.h.
    Matrix at_mid_step(const Matrix &C, const double dt)
    {
      return C * (Matrix::Identity() + 0.5 * dt * C).inverse();
    }

    struct Account
    {
      const Interpolation at;
      const MomentumSource source;
      double dt;
      bool count_reaction; // else the forces were left out
      const Points &points = source.points;

      Point push(const std::size_t p) const
      {
        return dt * points.mass[p] * source.acceleration.at(p);
      }
      Matrix stress(const std::size_t p) const // times volume and dt
      {
        Matrix s;
        s << points.sxx[p], points.sxy[p], points.sxy[p], points.syy[p];
        return dt * points.mass[p] * source.inverse_density * points.jacobian[p] * s;
      }

      // As scatter does.
      void parts(Supports &supports, const std::size_t p) const
      {
        const Prescribed &point = supports.prescribed[p];
        const Point velocity(points.vx[p], points.vy[p]), pushed = push(p);
        const Matrix stressed = stress(p);
        Matrix affine = Matrix::Zero();
        if (at.scheme.affine())
          affine << points.lxx[p], points.lxy[p], points.lyx[p], points.lyy[p];
        const Stencil s = stencil(at, {points.x[p], points.y[p]});
        const auto add = [&](const int k, const std::ptrdiff_t node, const auto &turn)
        {
          const int a = k % 3, b = k / 3;
          const double w = s.x.w[a] * s.y.w[b], m = points.mass[p] * w;
          const Point d(s.x.d[a], s.y.d[b]);
          const Point slope(s.x.g[a] * s.y.w[b], s.x.w[a] * s.y.g[b]);
          for (int c = 0; c < 2; ++c)
            if (point.support[c] >= 0)
            {
              DrivenPart &part = supports.driven_parts[node][c];
              part.mass += m;
              part.momentum += turn.sign[c] * m * (velocity[c] + affine.row(c).dot(d));
              if (count_reaction)
                part.impulse += turn.sign[c] * (w * pushed[c] - stressed.row(c).dot(slope));
            }
        };
        const bool turned = near_mirror(at.grid, s.i, s.j, 1);
        for (int k = 0; k < 9; ++k)
        {
          const int i = s.i - 1 + k % 3, j = s.j - 1 + k / 3;
          if (!turned)
            add(k, at.grid.at(i, j), Straight{});
          else if (const Image image = image_of(at.grid, i, j); image.node >= 0)
            add(k, image.node, image);
        }
      }

      void add_reaction(Supports &supports, const std::size_t p) const
      {
        const Prescribed &point = supports.prescribed[p];
        const Point before(points.vx[p], points.vy[p]), &v = point.velocity, pushed = push(p);
        const Matrix stressed = stress(p);
        Matrix gradient_before;
        gradient_before << points.lxx[p], points.lxy[p], points.lyx[p], points.lyy[p];
        Matrix gradient = gradient_before; // of a component that is free
        for (int c = 0; c < 2; ++c)
          if (point.support[c] >= 0)
            gradient.row(c) = point.gradient.row(c);
        const Matrix strained =
            0.5 * (at_mid_step(gradient, dt) + at_mid_step(gradient_before, dt));
        for (int c = 0; c < 2; ++c)
          if (point.support[c] >= 0)
          {
            Support &support = supports.all[point.support[c]];
            const double impulse = points.mass[p] * (v[c] - before[c]) - pushed[c];
            const double work = 0.5 * points.mass[p] * (v[c] * v[c] - before[c] * before[c]) -
                                0.5 * pushed[c] * (v[c] + before[c]) +
                                stressed.row(c).dot(strained.row(c));
            support.impulse[c] += impulse, support.call_impulse[c] += impulse;
            supports.work += work, supports.work_done += std::abs(work);
            supports.speed = std::max(supports.speed, std::abs(v[c]));
          }
      }
    };
  } // namespace

  void prescribe(Solid &solid, const HeldStep &step)
  {
    Supports &supports = solid.supports;
    const Points &points = solid.points;
    const Grid &grid = solid.grid;
    supports.speed = 0.;
    if (supports.driven.empty())
      return;
    for (DrivenRegion &region : supports.driven)
      region.covers.assign(grid.nodes.size(), {});
    supports.driven_parts.assign(grid.nodes.size(), {});
    supports.prescribed.assign(points.active, {});
    const Account account{solid.interpolation(), solid.momentum_source(), step.dt,
                          step.count_reaction};
    for (std::size_t p = 0; p < points.active; ++p)
    {
      bool any = false;
      for (DrivenRegion &region : supports.driven)
        if (points.regions[p] & (1u << region.region))
        {
          const Motion &motion = supports.all[region.support].motion;
          const AffineMotion near =
              affine_around({solid.fraction.initial(points, p), {points.x[p], points.y[p]}, step.t},
                            motion, step.dt, 0.01 * grid.dx);
          prescribe(supports.prescribed[p], motion, near, region.support);
          add_to_covers(region, near, grid);
          any = true;
        }
      if (any)
        account.parts(supports, p);
      if (any && step.count_reaction)
        account.add_reaction(supports, p);
    }
  }

  void move_as_prescribed(const Supports &supports, Points &points, const bool gradient_only,
                          const PointRange range)
  {
    if (supports.driven.empty())
      return;
    for (std::size_t p = range.begin; p < range.end; ++p)
    {
      const Prescribed &point = supports.prescribed[p];
      if (point.support[0] >= 0)
        points.lxx[p] = point.gradient(0, 0), points.lxy[p] = point.gradient(0, 1);
      if (point.support[1] >= 0)
        points.lyx[p] = point.gradient(1, 0), points.lyy[p] = point.gradient(1, 1);
      if (point.support[0] >= 0 && !gradient_only)
        points.vx[p] = point.velocity[0];
      if (point.support[1] >= 0 && !gradient_only)
        points.vy[p] = point.velocity[1];
    }
  }

  void move_driven_points(const Supports &supports, Points &points)
  {
    for (std::size_t p = 0; p < supports.prescribed.size(); ++p)
    {
      const Prescribed &point = supports.prescribed[p];
      if (point.support[0] >= 0)
        points.x[p] = point.position[0];
      if (point.support[1] >= 0)
        points.y[p] = point.position[1];
    }
  }

  double largest_prescribed_speed(const Supports &supports, const double end)
  {
    double largest = 0.;
    for (const Support &support : supports.all)
      for (const Point &X : support.corners)
      {
        const auto at = [&](const double t) { return support.motion.at(X, X, t); };
        largest = std::max(largest, scene::largest_speed(at, end));
        if (support.motion.uniform)
          break; // all corners move alike
      }
    return largest;
  }
} // namespace solid
