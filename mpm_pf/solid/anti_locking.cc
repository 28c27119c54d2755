#include "solid/anti_locking.h"

#include "solid/blocks.h"
#include "solid/constitutive.h"
#include "solid/wide.h"

namespace solid
{
  namespace
  {
    constexpr std::size_t chunk = 64;

    // Rows of cells in which points of the block may be: they have moved a quarter of a cell at
    // most from where the nodes of these rows were nearest.
    int first_row(const Grid &grid, const int block)
    {
      return std::max(grid.blocks[block].row - 1, grid.row_begin);
    }
    int end_row(const Grid &grid, const int block)
    {
      return std::min(grid.blocks[block].row + rows_per_block, grid.row_end);
    }

    struct Chunk
    {
      alignas(64) double volume[chunk], strain[chunk], pressure[chunk], sums[4 * chunk];
      std::int32_t i[chunk], j[chunk];
    };

    void evaluate(const Points &points, const Grid &grid, const Step &step, Chunk &now,
                  const PointRange range)
    {
      const std::size_t begin = range.begin, count = range.size();
      const double *const x = &points.x[begin], *const y = &points.y[begin];
      const double *const lxx = &points.lxx[begin], *const lxy = &points.lxy[begin];
      const double *const lyx = &points.lyx[begin], *const lyy = &points.lyy[begin];
      const double *const sxx = &points.sxx[begin], *const syy = &points.syy[begin];
      const double *const szz = &points.szz[begin];
      const double *const mass = &points.mass[begin], *const jacobian = &points.jacobian[begin];
      const double x0 = grid.lower[0], y0 = grid.lower[1], scale = grid.inverse_dx;
      const double inverse_density = step.inverse_density, dt = step.dt;
#pragma omp simd
      for (std::size_t k = 0; k < count; ++k)
      {
        const Increment e = increment(lxx[k], lxy[k], lyx[k], lyy[k], dt);
        const double volume = mass[k] * inverse_density * jacobian[k];
        now.volume[k] = volume;
        now.strain[k] = volume * (e.xx + e.yy);
        now.pressure[k] = volume * pressure({sxx[k], syy[k], szz[k], 0.});
        now.i[k] = static_cast<std::int32_t>(std::floor((x[k] - x0) * scale));
        now.j[k] = static_cast<std::int32_t>(std::floor((y[k] - y0) * scale));
      }
      for (std::size_t k = 0; k < count; k += wide)
        store_quads(&now.sums[4 * k], load<Lanes>(&now.volume[k]), load<Lanes>(&now.strain[k]),
                    load<Lanes>(&now.pressure[k]), Lanes{});
    }
  } // namespace

  void clear_cells(CellMeans &cells, const Grid &grid, const int block)
  {
    const auto [begin, end] = grid.range(first_row(grid, block), end_row(grid, block));
    std::fill(cells.sums[block % 2].begin() + begin, cells.sums[block % 2].begin() + end,
              CellMeans::Sum{});
  }

  void add_to_cells(CellMeans &cells, const Points &points, const Grid &grid, const Step &step,
                    const Piece &piece)
  {
    CellMeans::Sum *const sums = cells.sums[piece.block % 2].data();
    Chunk now{};
    const std::size_t end = piece.points.end;
    for (std::size_t p = piece.points.begin; p < end; p += chunk)
    {
      const std::size_t count = std::min(chunk, end - p);
      evaluate(points, grid, step, now, {p, p + count});
      for (std::size_t k = 0; k < count; ++k)
      {
        const auto n = static_cast<std::int32_t>(grid.at(now.i[k], now.j[k]));
        cells.cell[p + k] = n;
        sums[n].value += load<Quad>(&now.sums[4 * k]);
      }
    }
  }

  void average_cells(CellMeans &cells, const Grid &grid, const int block)
  {
    const auto average = [&](const std::ptrdiff_t n, const Quad &sum)
    {
      const double inverse = sum[0] > 0. ? 1. / sum[0] : 0.;
      cells.mean[n] = {sum[1] * inverse, sum[2] * inverse};
    };
    const Array<CellMeans::Sum> &own = cells.sums[block % 2], &other = cells.sums[1 - block % 2];
    const bool last = block + 1 == static_cast<int>(grid.blocks.size());
    int row = first_row(grid, block);
    if (block > 0)
    {
      const auto [begin, end] = grid.range(row, row + 1);
      for (std::ptrdiff_t n = begin; n < end; ++n)
        average(n, own[n].value + other[n].value);
      ++row;
    }
    const auto [begin, end] = grid.range(row, end_row(grid, block) - (last ? 0 : 1));
    for (std::ptrdiff_t n = begin; n < end; ++n)
      average(n, own[n].value);
  }
} // namespace solid
