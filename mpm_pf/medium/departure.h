// Where the material at a node comes from within one step, and how the way there is deformed.
#pragma once

#include <algorithm>
#include <cmath>

#include "medium/field.h"

namespace medium
{
  /// Three rows of each velocity component round the row in hand.
  struct VelocityRows
  {
    const double *u_below, *u, *u_above, *v_below, *v, *v_above;
  };

  inline VelocityRows velocity_rows(const Velocity &velocity, int j)
  {
    return {velocity.x.row(j - 1), velocity.x.row(j), velocity.x.row(j + 1),
            velocity.y.row(j - 1), velocity.y.row(j), velocity.y.row(j + 1)};
  }

  /// dt over the spacings: velocities times these are shifts in cells.
  struct StepInCells
  {
    double x, y;
  };

  /// Largest of |u| dt/dx and |v| dt/dy along a row.
  inline double largest_shift(const VelocityRows &w, int count, StepInCells dt)
  {
    const double *u = w.u, *v = w.v;
    double x = 0., y = 0.;
#pragma omp simd reduction(max : x, y)
    for (int i = 0; i < count; ++i)
    {
      const double a = std::fabs(u[i]), b = std::fabs(v[i]);
      x = a > x ? a : x;
      y = b > y ? b : y;
    }
    return std::max(x * dt.x, y * dt.y);
  }

  /// Shift to the departure point in cells, and the Jacobian of the departure map in cell units.
  struct Departure
  {
    double x, y, xx, xy, yx, yy;
  };

  /// At node i: x + xi, xi = -v dt + 1/2 dt^2 (v . grad) v, and I - dt A + 1/2 dt^2 A^2, A = grad
  /// v.
  // Forced inline, as the corners of the cell: as a call it would keep the loop over nodes scalar.
  [[gnu::always_inline]] inline Departure departure(const VelocityRows &w, int i, StepInCells dt)
  {
    const double u = w.u[i] * dt.x, v = w.v[i] * dt.y;
    const double u_x = 0.5 * dt.x * (w.u[i + 1] - w.u[i - 1]);
    const double u_y = 0.5 * dt.x * (w.u_above[i] - w.u_below[i]);
    const double v_x = 0.5 * dt.y * (w.v[i + 1] - w.v[i - 1]);
    const double v_y = 0.5 * dt.y * (w.v_above[i] - w.v_below[i]);
    const double trace = u_x + v_y;
    return {-u + 0.5 * (u * u_x + v * u_y),
            -v + 0.5 * (u * v_x + v * v_y),
            1. - u_x + 0.5 * (u_x * u_x + u_y * v_x),
            -u_y + 0.5 * u_y * trace,
            -v_x + 0.5 * v_x * trace,
            1. - v_y + 0.5 * (v_y * v_y + u_y * v_x)};
  }
} // namespace medium
