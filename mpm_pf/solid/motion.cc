#include "solid/motion.h"

#include <Eigen/LU>

#include "medium/numerical_error.h"
#include "scene/value.h"

namespace solid
{
  Point Motion::at(const Point &X, const Point &x, const double t) const
  {
    if (driven)
      return driven->displacement + (t - driven->since) * driven->velocity;
    Point u = Point::Zero();
    for (int c = 0; c < 2; ++c)
      if (displacement[c])
        u[c] = (*displacement[c])({X, x, t});
    return u;
  }

  Eigen::Matrix2d Motion::gradient(const Point &X, const Point &x, const double t,
                                   const double h) const
  {
    Eigen::Matrix2d F = Eigen::Matrix2d::Identity();
    for (int k = 0; k < 2; ++k)
    {
      const Point step = h * Point::Unit(k);
      F.col(k) += (at(X + step, x, t) - at(X - step, x, t)) / (2. * h);
    }
    return F;
  }

  Point Motion::origin(const Point &x, const double t, const double dx) const
  {
    if (uniform)
      return x - at(x, x, t);
    // Small displacement gradients shrink what is missing by themselves; Newton's method, whose
    // gradients cost four more looks, does where they do not.
    constexpr int most_iterations = 50;
    Point X = x;
    double before = 0.;
    for (int k = 0; k < most_iterations; ++k)
    {
      const Point missing = x - X - at(X, x, t);
      const double size = missing.norm();
      if (size <= 1e-9 * dx)
        return X;
      const bool shrinks = k == 0 || size < 0.1 * before;
      X += shrinks ? missing : Point(gradient(X, x, t, 0.01 * dx).inverse() * missing);
      before = size;
    }
    throw medium::NumericalError("a support's displacement brings no material to (" +
                                 scene::number_text(x[0]) + ", " + scene::number_text(x[1]) +
                                 ") at time " + scene::number_text(t) +
                                 ", where it holds some: it folds the material that it holds");
  }
} // namespace solid
