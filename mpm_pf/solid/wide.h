// Vectors of one quantity of eight points, and of four quantities of one point, in and out of
// memory.
#pragma once

#include <cstring>

#include "solid/grid.h"

namespace solid
{
  inline constexpr std::size_t wide = 8;
  typedef double Lanes __attribute__((vector_size(64), may_alias)); // one quantity of eight points
  typedef double Pair __attribute__((vector_size(16), may_alias));

  template <typename Vector>
  inline __attribute__((always_inline)) Vector load(const double *from)
  {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
  }

  template <typename Vector>
  inline __attribute__((always_inline)) void store(double *to, const Vector &vector)
  {
    std::memcpy(to, &vector, sizeof vector);
  }

  /// The first `count` of eight values, zeros behind them.
  inline __attribute__((always_inline)) Lanes load_some(const double *from, const std::size_t count)
  {
    if (count >= wide)
      return load<Lanes>(from);
    Lanes lanes{};
    for (std::size_t k = 0; k < count; ++k)
      lanes[k] = from[k];
    return lanes;
  }

  inline __attribute__((always_inline)) void store_some(double *to, const Lanes &lanes,
                                                        const std::size_t count)
  {
    if (count >= wide)
      return store(to, lanes);
    for (std::size_t k = 0; k < count; ++k)
      to[k] = lanes[k];
  }

  /// to = {a0, b0, a1, b1, ...}
  inline __attribute__((always_inline)) void store_pairs(double *to, const Lanes &a, const Lanes &b)
  {
    store<Lanes>(to, __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11));
    store<Lanes>(to + 8, __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15));
  }

  /// to = {a0, b0, c0, d0, a1, b1, ...}
  inline __attribute__((always_inline)) void store_quads(double *to, const Lanes &a, const Lanes &b,
                                                         const Lanes &c, const Lanes &d)
  {
    const Lanes ab[2] = {__builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11),
                         __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15)};
    const Lanes cd[2] = {__builtin_shufflevector(c, d, 0, 8, 1, 9, 2, 10, 3, 11),
                         __builtin_shufflevector(c, d, 4, 12, 5, 13, 6, 14, 7, 15)};
    for (int half = 0; half < 2; ++half)
    {
      store<Lanes>(to + 16 * half,
                   __builtin_shufflevector(ab[half], cd[half], 0, 1, 8, 9, 2, 3, 10, 11));
      store<Lanes>(to + 16 * half + 8,
                   __builtin_shufflevector(ab[half], cd[half], 4, 5, 12, 13, 6, 7, 14, 15));
    }
  }

  struct FourLanes
  {
    Lanes a, b, c, d;
  };

  /// The inverse of store_quads.
  inline __attribute__((always_inline)) FourLanes load_quads(const double *from)
  {
    const Lanes q0 = load<Lanes>(from), q1 = load<Lanes>(from + 8);
    const Lanes q2 = load<Lanes>(from + 16), q3 = load<Lanes>(from + 24);
    const Lanes ab0 = __builtin_shufflevector(q0, q1, 0, 4, 8, 12, 1, 5, 9, 13);
    const Lanes ab1 = __builtin_shufflevector(q2, q3, 0, 4, 8, 12, 1, 5, 9, 13);
    const Lanes cd0 = __builtin_shufflevector(q0, q1, 2, 6, 10, 14, 3, 7, 11, 15);
    const Lanes cd1 = __builtin_shufflevector(q2, q3, 2, 6, 10, 14, 3, 7, 11, 15);
    return {__builtin_shufflevector(ab0, ab1, 0, 1, 2, 3, 8, 9, 10, 11),
            __builtin_shufflevector(ab0, ab1, 4, 5, 6, 7, 12, 13, 14, 15),
            __builtin_shufflevector(cd0, cd1, 0, 1, 2, 3, 8, 9, 10, 11),
            __builtin_shufflevector(cd0, cd1, 4, 5, 6, 7, 12, 13, 14, 15)};
  }
} // namespace solid
