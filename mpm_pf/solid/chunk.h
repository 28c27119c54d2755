// A chunk of points made ready for the sums over nodes of scatter.cc and gather.cc.
//
// The two sums have the same shape: per point nine products of weights, each times a few numbers.
// They run over vectors of four lanes that hold the components of one point (momentum and force, or
// value and slope), so no lane is idle however few points share a node, and what a node gets or
// gives stays in a register while points that share it follow each other. What such vectors are
// made of is computed here, eight points side by side, and put into the order in which it is read.
#pragma once

#include "solid/stencil.h"
#include "solid/wide.h"

namespace solid
{
  inline constexpr std::size_t chunk_points = 64;

  /// Weights along one direction, on the three nodes of each point.
  struct ChunkWeights
  {
    alignas(64) double w[3][chunk_points];         // weight
    alignas(64) double pairs[3][2 * chunk_points]; // {weight times distance, or weight; slope}

    double weight(const int a, const std::size_t k) const { return w[a][k]; }
    /// {first, slope, first, slope}
    Quad pair(const int a, const std::size_t k) const
    {
      const Pair p = load<Pair>(&pairs[a][2 * k]);
      return __builtin_shufflevector(p, p, 0, 1, 0, 1);
    }
  };

  /// Points [begin, end) of a chunk that share the nine nodes of which row[b] is the first of a
  /// row.
  struct Run
  {
    std::array<std::ptrdiff_t, 3> row;
    std::size_t begin, end;
  };

  /// Nearest nodes and weights of a chunk of points. `moments`: pairs start with weight times
  /// distance, as points to nodes needs it; else with the weight.
  template <Shape shape, bool moments>
  struct Chunk
  {
    ChunkWeights x, y;
    std::int32_t i[chunk_points], j[chunk_points];
    std::size_t count; // of its points

    void prepare(const Interpolation &at, const Points &points, const PointRange range)
    {
      const Grid &grid = at.grid;
      const std::array<double, 2> &half_size = at.scheme.half_size;
      count = range.size();
      Offsets offset;
      locate(grid, points, range, offset);
      for (std::size_t k = 0; k < range.size(); k += wide)
      {
        fill(x, k, wide_weights(load<Lanes>(offset.x + k), grid, half_size[0]));
        fill(y, k, wide_weights(load<Lanes>(offset.y + k), grid, half_size[1]));
      }
      if (at.folds.pairs.empty())
        return;
      for (std::size_t k = 0; k < range.size(); ++k)
        if (grid.fold[grid.at(i[k], j[k])] != 0)
        {
          const Stencil folded =
              stencil_of<shape>(at, points.x[range.begin + k], points.y[range.begin + k]);
          replace(x, k, folded.x), replace(y, k, folded.y);
          i[k] = folded.i, j[k] = folded.j;
        }
    }

    /// The points from k on that share the node of point k.
    Run run_from(const std::size_t k, const Grid &grid) const
    {
      std::size_t end = k + 1;
      while (end < count && i[end] == i[k] && j[end] == j[k])
        ++end;
      return {{grid.at(i[k] - 1, j[k] - 1), grid.at(i[k] - 1, j[k]), grid.at(i[k] - 1, j[k] + 1)},
              k,
              end};
    }

  private:
    struct Wide
    {
      Lanes w[3], g[3], d[3];
    };

    // Of the points from their nearest nodes, in cells.
    struct Offsets
    {
      alignas(64) double x[chunk_points], y[chunk_points];
    };

    void locate(const Grid &grid, const Points &points, const PointRange range, Offsets &offset)
    {
      const double *const px = &points.x[range.begin], *const py = &points.y[range.begin];
      double *const s = offset.x, *const t = offset.y;
      const double x0 = grid.lower[0], y0 = grid.lower[1], scale = grid.inverse_dx;
#pragma omp simd
      for (std::size_t k = 0; k < range.size(); ++k)
      {
        const double a = (px[k] - x0) * scale, b = (py[k] - y0) * scale;
        const double nearest_a = std::floor(a + 0.5), nearest_b = std::floor(b + 0.5);
        s[k] = a - nearest_a, t[k] = b - nearest_b;
        i[k] = static_cast<std::int32_t>(nearest_a), j[k] = static_cast<std::int32_t>(nearest_b);
      }
      for (std::size_t k = range.size(); k % wide != 0; ++k)
        s[k] = t[k] = 0.;
    }

    // As weights() of shape_functions.h, for eight points.
    static inline __attribute__((always_inline)) Wide wide_weights(const Lanes &s, const Grid &grid,
                                                                   const double half_size)
    {
      Lanes left, right, left_slope, right_slope;
      const Lanes none{};
      if constexpr (shape == Shape::quadratic_bspline)
      {
        const Lanes a = 0.5 - s, b = 0.5 + s;
        left = 0.5 * a * a, right = 0.5 * b * b, left_slope = -a, right_slope = b;
      }
      else if constexpr (shape == Shape::ugimp)
      {
        const double l = half_size, scale = 0.25 / l;
        const Lanes whole = none + 2. * l;
        Lanes a = l - s, b = l + s;
        a = a > none ? a : none, b = b > none ? b : none;
        a = a < whole ? a : whole, b = b < whole ? b : whole;
        const Lanes beyond_left = -s - l, beyond_right = s - l;
        left = a * a * scale + (beyond_left > none ? beyond_left : none);
        right = b * b * scale + (beyond_right > none ? beyond_right : none);
        left_slope = -2. * scale * a, right_slope = 2. * scale * b;
      }
      else
      {
        const Lanes one = none + 1.;
        left = s < none ? -s : none, right = s > none ? s : none;
        left_slope = s < none ? -one : none, right_slope = s < none ? none : one;
      }
      const Lanes x = s * grid.dx;
      return {{left, 1. - left - right, right},
              {left_slope * grid.inverse_dx, -(left_slope + right_slope) * grid.inverse_dx,
               right_slope * grid.inverse_dx},
              {-grid.dx - x, -x, grid.dx - x}};
    }

    static inline __attribute__((always_inline)) void fill(ChunkWeights &to, const std::size_t k,
                                                           const Wide &from)
    {
      for (int a = 0; a < 3; ++a)
      {
        if constexpr (moments)
          store(&to.w[a][k], from.w[a]);
        store_pairs(&to.pairs[a][2 * k], moments ? from.w[a] * from.d[a] : from.w[a], from.g[a]);
      }
    }

    static void replace(ChunkWeights &to, const std::size_t k, const Weights &from)
    {
      for (int a = 0; a < 3; ++a)
      {
        to.w[a][k] = from.w[a];
        to.pairs[a][2 * k] = moments ? from.w[a] * from.d[a] : from.w[a];
        to.pairs[a][2 * k + 1] = from.g[a];
      }
    }
  };
} // namespace solid
