#include <Eigen/LU>

#include "solid/supports.h"

namespace solid
{
  namespace
  {
    using Matrix = Eigen::Matrix2d;

    // I + du/dX by central differences; exact for affine motions.
    Matrix deformation(const Motion &motion, const Point &X, const Point &x, const double t,
                       const double h)
    {
      Matrix F = Matrix::Identity();
      for (int k = 0; k < 2; ++k)
      {
        const Point step = h * Point::Unit(k);
        F.col(k) += (motion.at(X + step, x, t) - motion.at(X - step, x, t)) / (2. * h);
      }
      return F;
    }
  } // namespace

  void project(DrivenRegion &region, const Motion &motion, const Scheme &scheme,
               const FoldTable &folds, const Points &points, const Fraction &fraction,
               const Grid &grid, const double t, const double dt)
  {
    region.sums.assign(grid.nodes.size(), {0., 0., 0.});
    region.increment.clear();
    for (std::size_t p = 0; p < points.active; ++p)
    {
      if (!(points.regions[p] & (1u << region.region)))
        continue;
      const Point X = fraction.initial(points, p), x{points.x[p], points.y[p]};
      const double h = 0.01 * grid.dx;
      const Point step = motion.at(X, x, t + dt) - motion.at(X, x, t);
      const Matrix C =
          (deformation(motion, X, x, t + dt, h) * deformation(motion, X, x, t, h).inverse() -
           Matrix::Identity()) /
          dt;
      region.increment.push_back(step);
      const Stencil s = stencil(scheme, grid, folds, x);
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
        {
          const double m = points.mass[p] * s.x.w[a] * s.y.w[b];
          const Point v = step / dt + C * Point(s.x.d[a], s.y.d[b]);
          auto &sum = region.sums[grid.at(s.i - 1 + a, s.j - 1 + b)];
          sum[0] += m, sum[1] += m * v[0], sum[2] += m * v[1];
        }
    }
  }

  void carry_driven(Supports &supports, const DrivenRegion &region, Points &points,
                    const Fraction &fraction, const double t, const double dt)
  {
    Support &support = supports.all[region.support];
    const Motion &motion = support.motion;
    Point impulse = Point::Zero();
    double work = 0.;
    std::size_t k = 0;
    for (std::size_t p = 0; p < points.active; ++p)
    {
      if (!(points.regions[p] & (1u << region.region)))
        continue;
      const Point X = fraction.initial(points, p), v = region.increment[k++] / dt;
      const Point u = motion.at(X, {points.x[p], points.y[p]}, t + dt);
      for (int c = 0; c < 2; ++c)
      {
        if (!motion.holds(c))
          continue;
        (c == 0 ? points.x : points.y)[p] = X[c] + u[c];
        double &velocity = (c == 0 ? points.vx : points.vy)[p];
        const double given = points.mass[p] * (v[c] - velocity);
        impulse[c] += given, work += given * v[c];
        velocity = v[c];
      }
    }
    support.impulse += impulse, support.call_impulse += impulse;
    supports.work += work, supports.work_done += std::abs(work);
  }

  double largest_prescribed_speed(const Supports &supports, const double end)
  {
    constexpr int samples = 400;
    double largest = 0.;
    for (const Support &support : supports.all)
      for (int k = 0; k < samples; ++k)
        for (const Point &X : support.corners)
        {
          const double h = end / samples, t = k * h;
          const Point step = support.motion.at(X, X, t + h) - support.motion.at(X, X, t);
          largest = std::max(largest, step.norm() / h);
        }
    return largest;
  }
} // namespace solid
