// The material points: one array per quantity, so that each kernel streams only what it needs.
//
// 130 bytes a point: 15 doubles, the initial position as two 32-bit fractions of the domain (points
// start exactly on such a fraction, hence displacements are exact to the last bit of a double), and
// 16 bits saying which regions of material it belongs to. Points [0, active) move by Eq. (4) and
// are kept in the order of the grid (grid.h); the rest sits in rigid grips.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "scene/scene.h"

namespace solid
{
  using scene::Point;

  /// Arrays start on a cache line, large ones on a large page: a step goes through fifteen arrays
  /// at once, each of them in another page.
  inline void *allocate_array(const std::size_t bytes)
  {
    constexpr std::size_t line = 64, large_page = std::size_t(1) << 21;
    void *const memory =
        ::operator new(bytes, std::align_val_t(bytes < large_page ? line : large_page));
    if (bytes >= large_page)
      madvise(memory, bytes, MADV_HUGEPAGE); // a wish: where it is refused, small pages do
    return memory;
  }
  inline void free_array(void *const memory, const std::size_t bytes)
  {
    constexpr std::size_t line = 64, large_page = std::size_t(1) << 21;
    ::operator delete(memory, std::align_val_t(bytes < large_page ? line : large_page));
  }

  template <typename T>
  struct Aligned
  {
    using value_type = T;
    Aligned() = default;
    template <typename U>
    Aligned(const Aligned<U> &)
    {
    }
    T *allocate(const std::size_t n) { return static_cast<T *>(allocate_array(n * sizeof(T))); }
    void deallocate(T *p, const std::size_t n) { free_array(p, n * sizeof(T)); }
    bool operator==(const Aligned &) const { return true; }
    bool operator!=(const Aligned &) const { return false; }
  };
  template <typename T>
  using Array = std::vector<T, Aligned<T>>;

  struct Points
  {
    Array<double> x, y;               // position
    Array<double> vx, vy;             // velocity
    Array<double> lxx, lxy, lyx, lyy; // velocity gradient (affine part of the transfer)
    Array<double> sxx, syy, szz, sxy; // Cauchy stress
    Array<double> plastic;            // equivalent plastic strain
    Array<double> jacobian;           // current over initial area
    Array<double> mass;               // per unit depth
    Array<std::uint32_t> X, Y;        // initial position, see Fraction
    Array<std::uint16_t> regions;     // bit r: started in region r
    Array<float> rxx, rxy, ryx, ryy;  // edges of its material, columns; only if points may split
    bool may_split = false;
    std::size_t active = 0; // these move by Eq. (4), the rest with a rigid grip

    std::size_t size() const { return x.size(); }
  };

  /// Points [begin, end), which lie one behind the other in every array.
  struct PointRange
  {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
  };

  /// Call f(name, array) for every array of state; the one list of them.
  template <typename PointsOrConst, typename F>
  void for_each_array(PointsOrConst &points, F &&f)
  {
    f("x", points.x), f("y", points.y), f("vx", points.vx), f("vy", points.vy);
    f("lxx", points.lxx), f("lxy", points.lxy), f("lyx", points.lyx), f("lyy", points.lyy);
    f("sxx", points.sxx), f("syy", points.syy), f("szz", points.szz), f("sxy", points.sxy);
    f("plastic", points.plastic), f("jacobian", points.jacobian), f("mass", points.mass);
    f("X", points.X), f("Y", points.Y), f("regions", points.regions);
    if (points.may_split)
      f("rxx", points.rxx), f("rxy", points.rxy), f("ryx", points.ryx), f("ryy", points.ryy);
  }

  /// Bytes of state of one point.
  inline std::size_t bytes_per_point(const bool may_split = false)
  {
    std::size_t bytes = 0;
    Points none;
    none.may_split = may_split;
    for_each_array(none, [&](const char *, const auto &array) { bytes += sizeof(array[0]); });
    return bytes;
  }

  /// Initial positions are multiples of size/2^32 of the domain.
  struct Fraction
  {
    Point lower, unit;
    explicit Fraction(const scene::Domain &domain)
        : lower(domain.lower), unit(domain.size / 4294967296.)
    {
    }
    std::uint32_t encode(const double x, const int axis) const
    {
      return static_cast<std::uint32_t>((x - lower[axis]) / unit[axis] + 0.5);
    }
    double decode(const std::uint32_t X, const int axis) const
    {
      return lower[axis] + X * unit[axis];
    }
    Point initial(const Points &points, const std::size_t p) const
    {
      return {decode(points.X[p], 0), decode(points.Y[p], 1)};
    }
  };

  /// Memory for `count` points in all, so that adding them moves none.
  void reserve(Points &, std::size_t count);

  /// Add a point at rest, free of stress, at `position` (rounded to a fraction of the domain).
  void add_point(Points &, const Fraction &, const Point &position, double mass);

  /// Bring the points into a new order: point order[k] goes to place k. One array at a time through
  /// one scratch array. `order` covers the first order.size() points.
  void reorder(Points &, const std::vector<std::uint32_t> &order, Array<double> &scratch,
               int threads);
} // namespace solid
