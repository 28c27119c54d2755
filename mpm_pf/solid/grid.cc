#include "solid/grid.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace solid
{
  namespace
  {
    constexpr int margin = 3; // a stencil, a point astray by one node, and the tracers beyond it

    void find_rows(const Points &points, Grid &grid)
    {
      grid.row_begin = std::numeric_limits<int>::max(), grid.row_end = 0;
      int last = std::numeric_limits<int>::min();
      for (std::size_t p = 0; p < points.active; ++p)
      {
        const int j = grid.nearest(points.y[p], 1);
        grid.row_begin = std::min(grid.row_begin, j);
        last = std::max(last, j);
      }
      if (points.active == 0)
        grid.row_begin = 0, grid.row_end = 0;
      else
        grid.row_begin -= margin, grid.row_end = last + margin + 1;
    }

    // A row must hold the stencils of its neighbours' points too: take the widest of seven rows.
    void find_columns(const Points &points, Grid &grid)
    {
      const int rows = grid.row_end - grid.row_begin;
      std::vector<int> first(rows, std::numeric_limits<int>::max());
      std::vector<int> last(rows, std::numeric_limits<int>::min());
      for (std::size_t p = 0; p < points.active; ++p)
      {
        const int i = grid.nearest(points.x[p], 0);
        const int row = grid.nearest(points.y[p], 1) - grid.row_begin;
        first[row] = std::min(first[row], i), last[row] = std::max(last[row], i);
      }
      grid.column_begin.assign(rows, 0), grid.column_end.assign(rows, 0);
      for (int row = 0; row < rows; ++row)
      {
        int begin = std::numeric_limits<int>::max(), end = std::numeric_limits<int>::min();
        for (int k = std::max(0, row - margin); k <= std::min(rows - 1, row + margin); ++k)
          begin = std::min(begin, first[k]), end = std::max(end, last[k]);
        if (begin > end)
          begin = margin, end = -margin - 1; // nothing near: an empty range
        grid.column_begin[row] = begin - margin, grid.column_end[row] = end + margin + 1;
      }
    }

    void order_points(const Points &points, const Grid &grid, SortScratch &scratch)
    {
      scratch.key.resize(points.active), scratch.order.resize(points.active);
      scratch.count.assign(grid.nodes.size() + 1, 0);
      for (std::size_t p = 0; p < points.active; ++p)
      {
        const auto n = static_cast<std::uint32_t>(
            grid.at(grid.nearest(points.x[p], 0), grid.nearest(points.y[p], 1)));
        scratch.key[p] = n;
        ++scratch.count[n + 1];
      }
      std::partial_sum(scratch.count.begin(), scratch.count.end(), scratch.count.begin());
      for (std::size_t p = 0; p < points.active; ++p)
        scratch.order[scratch.count[scratch.key[p]]++] = static_cast<std::uint32_t>(p);
    }

    // After the sort count[n] is the end of node n's points.
    void cut_blocks(const Points &points, Grid &grid, const SortScratch &scratch)
    {
      grid.blocks.clear();
      std::size_t begin = 0;
      for (int j = grid.row_begin; j < grid.row_end; j += rows_per_block)
      {
        const int last = std::min(j + rows_per_block, grid.row_end) - grid.row_begin - 1;
        const std::ptrdiff_t n = grid.offset[last] + grid.column_end[last];
        const std::size_t end = j + rows_per_block >= grid.row_end ? points.active
                                : n > 0                            ? scratch.count[n - 1]
                                                                   : 0;
        grid.blocks.push_back({j, begin, end});
        begin = end;
      }
    }
  } // namespace

  void allocate(Grid &grid, const bool with_change)
  {
    const std::size_t rows = grid.column_begin.size();
    std::ptrdiff_t nodes = 0;
    grid.offset.resize(rows);
    for (std::size_t row = 0; row < rows; ++row)
    {
      grid.offset[row] = nodes - grid.column_begin[row];
      nodes += std::max(0, grid.column_end[row] - grid.column_begin[row]);
    }
    grid.mass.assign(nodes, 0.), grid.nodes.assign(nodes, Node{});
    grid.velocity.assign(nodes, Velocity{0., 0.});
    grid.change.assign(with_change ? nodes : 0, Velocity{0., 0.});
    grid.fold.assign(nodes, 0);
  }

  void sort(Points &points, Grid &grid, SortScratch &scratch, const bool with_change,
            const int threads)
  {
    find_rows(points, grid);
    find_columns(points, grid);
    allocate(grid, with_change);
    order_points(points, grid, scratch);
    cut_blocks(points, grid, scratch);
    if (!std::is_sorted(scratch.key.begin(), scratch.key.end()))
      reorder(points, scratch.order, scratch.values, threads);
    grid.drift = 0.;
  }
} // namespace solid
