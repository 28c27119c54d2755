// The nodes of the domain's cells near the points: only rows and columns in use have memory.
//
// Every row of nodes keeps one range of columns, three nodes wider than the points nearest to it;
// node (i, j) lies at offset[j] + i. Rows outside the domain may be in use too (the tails of a
// spline at its side). Points are put into the order of their nearest nodes, but only once some
// point may have moved a quarter of a cell: until then every point stays within one node of where
// it was sorted, which the ranges and the blocks of rows allow for.
//
// Blocks of eight rows are the units of work of the threads. Points of one block touch at most two
// rows of its neighbours, so that even blocks can be scattered at once, then odd ones: no locks,
// and the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solid/points.h"

// Vectors of 32 and 64 bytes are passed between inlined functions only: their calling convention on
// machines without such registers is of no interest.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace solid
{
  /// What one node gathers beside its mass: momentum p and force f, {p_x, f_x, p_y, f_y}.
  typedef double Quad __attribute__((vector_size(32), may_alias));
  struct Node
  {
    Quad motion;
    Point momentum() const { return {motion[0], motion[2]}; }
    Point force() const { return {motion[1], motion[3]}; }
  };
  struct Velocity
  {
    double x, y;
  };

  /// Points [begin, end) were nearest to the rows [row, row + rows_per_block) when they were
  /// sorted.
  struct Block
  {
    int row = 0;
    std::size_t begin = 0, end = 0;
  };
  inline constexpr int rows_per_block = 8;

  /// A symmetry side of the domain: a row (axis 1) or column (axis 0) of nodes, the material at
  /// larger numbers (side +1) or at smaller ones; see mirrors.h.
  struct Mirror
  {
    int axis, row, side;
  };

  struct Grid
  {
    std::vector<Mirror> mirrors; // those across x first
    Point lower = Point::Zero();
    double dx = 0., inverse_dx = 0.;
    std::array<int, 2> cells{0, 0}; // of the domain

    int row_begin = 0, row_end = 0;            // rows in use
    std::vector<int> column_begin, column_end; // of row j at [j - row_begin]
    std::vector<std::ptrdiff_t> offset;        // node (i, j) is offset[j - row_begin] + i
    std::vector<Block> blocks;
    Array<double> mass;
    Array<Node> nodes;
    Array<Velocity> velocity;       // after the step's forces and supports
    Array<Velocity> change;         // of velocity over the step: kept for flip and xpic only
    std::vector<std::uint8_t> fold; // 0: free; else 1 + index into the folds of supports.h
    double drift = 0.;              // largest possible motion of a point since the last sorting

    bool has(const int i, const int j) const
    {
      return j >= row_begin && j < row_end && i >= column_begin[j - row_begin] &&
             i < column_end[j - row_begin];
    }
    /// Has the nine nodes around x?
    bool surrounds(const Point &x) const
    {
      const int i = nearest(x[0], 0), j = nearest(x[1], 1);
      for (int k = 0; k < 9; ++k)
        if (!has(i - 1 + k % 3, j - 1 + k / 3))
          return false;
      return true;
    }
    std::ptrdiff_t at(const int i, const int j) const { return offset[j - row_begin] + i; }
    /// First and last + 1 of the columns of a row; equal outside the rows in use.
    std::pair<int, int> columns(const int row) const
    {
      if (row < row_begin || row >= row_end)
        return {0, 0};
      return {column_begin[row - row_begin], column_end[row - row_begin]};
    }
    /// First and last + 1 of the nodes of rows [first, end), which lie one behind the other.
    std::pair<std::ptrdiff_t, std::ptrdiff_t> range(const int first, const int end) const
    {
      if (first >= end)
        return {0, 0};
      return {at(column_begin[first - row_begin], first),
              at(std::max(column_begin[end - 1 - row_begin], column_end[end - 1 - row_begin]),
                 end - 1)};
    }
    double node_x(const int i) const { return lower[0] + i * dx; }
    double node_y(const int j) const { return lower[1] + j * dx; }
    int nearest(const double x, const int axis) const
    {
      return static_cast<int>(std::floor((x - lower[axis]) * inverse_dx + 0.5));
    }
    int cell(const double x, const int axis) const
    {
      return static_cast<int>(std::floor((x - lower[axis]) * inverse_dx));
    }
  };

  /// Call f(i, j, n) for every node of the rows in use, n = at(i, j).
  template <typename F>
  void for_each_node(const Grid &grid, F &&f)
  {
    for (int j = grid.row_begin; j < grid.row_end; ++j)
      for (int i = grid.column_begin[j - grid.row_begin]; i < grid.column_end[j - grid.row_begin];
           ++i)
        f(i, j, grid.at(i, j));
  }

  struct SortScratch
  {
    std::vector<std::uint32_t> key, order, count;
    Array<double> values;
  };

  /// Find the rows and columns in use, order the active points by their nearest node (a stable
  /// counting sort) and cut the rows into blocks. `with_change`: keep node velocities' change. Node
  /// values are zero afterwards.
  void sort(Points &, Grid &, SortScratch &, bool with_change, int threads);

  /// Offsets and node arrays for the rows and columns in use, all zero.
  void allocate(Grid &, bool with_change);
} // namespace solid
