// How the threads of a parallel region share the blocks of points. No result depends on how many
// there are: what meets at the sides of blocks is added in one order only.
#pragma once

#include <omp.h>

#include "solid/grid.h"

namespace solid
{
  inline constexpr std::size_t piece_points = 128;

  /// Points of one block that fit in the nearest cache.
  struct Piece
  {
    int block;
    PointRange points;
  };

  /// Call f(piece) for the pieces of block b. All but the first start on a cache line.
  template <typename F>
  void for_pieces(const std::vector<Block> &blocks, const int b, F &&f)
  {
    const Block &block = blocks[b];
    for (std::size_t p = block.begin, q; p < block.end; p = q)
    {
      q = std::min(p - p % piece_points + piece_points, block.end);
      f(Piece{b, {p, q}});
    }
  }

  /// Call f(b) for even blocks, then for odd ones: neighbours never write at the same time.
  template <typename F>
  void alternate(const std::vector<Block> &blocks, F &&f)
  {
    const int count = static_cast<int>(blocks.size());
    for (const int colour : {0, 1})
    {
#pragma omp for schedule(dynamic, 1)
      for (int b = colour; b < count; b += 2)
        f(b);
    }
  }

  /// Call f(b) for every block, in any order.
  template <typename F>
  void each(const std::vector<Block> &blocks, F &&f)
  {
    const int count = static_cast<int>(blocks.size());
#pragma omp for schedule(dynamic, 1)
    for (int b = 0; b < count; ++b)
      f(b);
  }

  /// Call first(b), between(b) and then(b) for every block: between(b) after first of b - 1 and b,
  /// then(b) after between of b and b + 1. Each thread goes through neighbouring blocks, so that
  /// `then` finds the points in a cache.
  template <typename First, typename Between, typename Then>
  void in_turn(const std::vector<Block> &blocks, First &&first, Between &&between, Then &&then)
  {
    const int count = static_cast<int>(blocks.size());
    const auto share = [&](const std::size_t thread) // first block of a thread
    {
      const std::size_t points = count > 0 ? blocks.back().end : 0;
      const std::size_t wanted = points * thread / static_cast<std::size_t>(omp_get_num_threads());
      int b = 0;
      while (thread > 0 && b < count && blocks[b].end <= wanted)
        ++b;
      return b;
    };
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const int begin = share(thread);
    const int end = omp_get_thread_num() + 1 == omp_get_num_threads() ? count : share(thread + 1);
    for (int b = begin; b < end; ++b)
    {
      first(b);
      if (b > begin || b == 0)
        between(b);
      if (b > begin && (b - 1 > begin || b == 1))
        then(b - 1);
    }
#pragma omp barrier
    if (begin > 0 && begin < end)
      between(begin);
#pragma omp barrier
    if (begin > 0 && begin + 1 < end)
      then(begin);
    if (begin < end)
      then(end - 1);
  }
} // namespace solid
