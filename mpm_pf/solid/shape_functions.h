// Shape functions of the material points on three nodes a direction, from the node nearest the
// point.
//
// With s = (x - x_nearest)/dx in [-1/2, 1/2] the weights of the left, centre and right node are
//   quadratic B-spline  wL = (1/2 - s)^2/2,              wR = (1/2 + s)^2/2
//   uGIMP               wL = m^2/4l + max(-s - l, 0),    m = clamp(l - s, 0, 2l), l: half size of a
//   point (cells) linear              wL = max(-s, 0),                 wR = max(s, 0)
// and wC = 1 - wL - wR, without a branch; wR mirrors wL. Bardenhagen & Kober (2004) for uGIMP,
// which the paper uses (Ref. 22). In two dimensions the weight is the product.
//
// **Held lines.** Prescribing the velocity of a row of nodes lets a B-spline slip there, since the
// nodes behind the row take part. So, near a straight boundary of the material at y_g, every row k
// behind the first inner row M is tied to the line and to M by linear extrapolation,
//   v_k = a_k v_g + (1 - a_k) v_M,   a_k = 1 - (y_k - y_g)/(y_M - y_g),
// and the row next to M, the carrier, stands for the line itself, at y_g with velocity v_g. For a
// line on the grid this is N1 -= N-1, N0 += 2 N-1, N-1 = 0; in general the line may move through
// the cells. The folded functions still sum to one and reproduce linear fields, are non-negative
// for points on the inner side, and take exactly the carrier's value on the line.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace solid
{
  using Shape = scene::ShapeFunction;

  /// Three nodes of one direction: weight, derivative along x (1/length), and node minus point
  /// (length).
  struct Weights
  {
    double w[3], g[3], d[3];
  };

  /// `s`: distance from the nearest node in cells; `dx`: cell size; `half_size` of a point in cells
  /// (uGIMP only).
  template <Shape shape>
  inline __attribute__((always_inline)) Weights
  weights(const double s, const double dx, const double inverse_dx, const double half_size)
  {
    double left, right, left_slope, right_slope;
    if constexpr (shape == Shape::quadratic_bspline)
    {
      const double a = 0.5 - s, b = 0.5 + s;
      left = 0.5 * a * a, right = 0.5 * b * b, left_slope = -a, right_slope = b;
    }
    else if constexpr (shape == Shape::ugimp)
    {
      const double l = half_size, scale = 0.25 / l;
      const double a = std::min(std::max(l - s, 0.), 2. * l);
      const double b = std::min(std::max(l + s, 0.), 2. * l);
      left = a * a * scale + std::max(-s - l, 0.), left_slope = -2. * a * scale;
      right = b * b * scale + std::max(s - l, 0.), right_slope = 2. * b * scale;
    }
    else
    {
      left = std::max(-s, 0.), right = std::max(s, 0.);
      left_slope = s < 0. ? -1. : 0., right_slope = s < 0. ? 0. : 1.;
    }
    const double x = s * dx;
    return {{left, 1. - left - right, right},
            {left_slope * inverse_dx, -(left_slope + right_slope) * inverse_dx,
             right_slope * inverse_dx},
            {-dx - x, -x, dx - x}};
  }

  /// A straight boundary of the material across one direction, as the shape functions see it.
  struct Fold
  {
    double position = 0.; // of the line
    int master = 0;       // first row of nodes inside the material
    int side = 1;         // +1: the material lies at larger coordinates, -1: at smaller
    int carrier() const { return master - side; }
  };

  /// The first inner row is between half a cell and one and a half from the line, so that the rows
  /// they stand for are never far extrapolated. Half-way between two rows, where rounding would
  /// choose, a line and its mirror image choose the same.
  inline Fold fold_at(const double position, const int side, const double lower, const double dx)
  {
    const double s = (position - lower) / dx, half = 0.5 + 1e-9;
    const double carrier = side > 0 ? std::floor(s + half) : std::ceil(s - half);
    return {position, static_cast<int>(carrier) + side, side};
  }

  /// Tie the rows behind `fold` in place. `nearest`: row of the centre node, either the carrier or
  /// the first inner row; `point`: coordinate of the point; `lower`: coordinate of row 0.
  inline void apply(const Fold &fold, const int nearest, const double point, const double lower,
                    const double dx, Weights &weights)
  {
    const int inner = fold.master - nearest + 1, carrier = fold.carrier() - nearest + 1;
    const double reach = 1. / (lower + fold.master * dx - fold.position);
    const Weights free = weights;
    for (int k = 0; k < 3; ++k)
      if ((inner - k) * fold.side > 0)
        weights.w[k] = weights.g[k] = 0.;
    for (int k = 0; k < 3; ++k)
      if ((inner - k) * fold.side > 0)
      {
        const double y_k = lower + (nearest - 1 + k) * dx;
        const double a_k = 1. - (y_k - fold.position) * reach;
        weights.w[carrier] += a_k * free.w[k];
        weights.g[carrier] += a_k * free.g[k];
        weights.w[inner] += (1. - a_k) * free.w[k];
        weights.g[inner] += (1. - a_k) * free.g[k];
      }
    weights.d[carrier] = fold.position - point;
  }
} // namespace solid
