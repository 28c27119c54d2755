// One quantity on the nodes of the mesh, with ghost layers.
//
// Rows are contiguous and node (0, j) of every row starts on a 64-byte line; the pitch is never a
// multiple of 4096 bytes, because rows at equal offsets of a page fight for the same cache sets.
// The field owns its memory and nothing else: kernels take row pointers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <utility>

#include "medium/mesh.h"

namespace medium
{
  /// Memory that begins on a 64-byte line; of huge pages, where it is large and the system has
  /// them: sweeps over several fields touch more pages at once than the processor keeps track of.
  /// To be given back by std::free. Throws std::bad_alloc.
  void *allocate_lines(std::size_t bytes);

  template <class T>
  class Field
  {
  public:
    /// An empty field; it holds no memory.
    Field() = default;
    /// `value` at all nodes and ghosts.
    explicit Field(const Mesh &mesh, T value = T{}) : nodes_x(mesh.nodes[0]), nodes_y(mesh.nodes[1])
    {
      row_pitch = lead + round_up(nodes_x + ghost_layers);
      if (row_pitch * sizeof(T) % 4096 == 0)
        row_pitch += lead;
      memory.reset(static_cast<T *>(allocate_lines(size() * sizeof(T))));
      std::fill_n(memory.get(), size(), value);
    }
    Field(const Field &other) { *this = other; }
    Field(Field &&other) noexcept { swap(other); }
    Field &operator=(const Field &other)
    {
      if (this == &other)
        return *this;
      if (size() != other.size())
        memory.reset(other.empty() ? nullptr
                                   : static_cast<T *>(allocate_lines(other.size() * sizeof(T))));
      nodes_x = other.nodes_x, nodes_y = other.nodes_y, row_pitch = other.row_pitch;
      std::copy_n(other.memory.get(), size(), memory.get());
      return *this;
    }
    Field &operator=(Field &&other) noexcept
    {
      swap(other);
      return *this;
    }
    void swap(Field &other) noexcept
    {
      std::swap(nodes_x, other.nodes_x), std::swap(nodes_y, other.nodes_y);
      std::swap(row_pitch, other.row_pitch), std::swap(memory, other.memory);
    }

    bool empty() const { return !memory; }
    int nodes(int axis) const { return axis == 0 ? nodes_x : nodes_y; }
    /// Elements from one row to the next.
    std::ptrdiff_t pitch() const { return static_cast<std::ptrdiff_t>(row_pitch); }
    std::size_t bytes() const { return size() * sizeof(T); }

    /// Pointer to node (0, j); valid for -ghost_layers <= i < nodes(0) + ghost_layers and the same
    /// range of j.
    T *row(int j) { return memory.get() + offset(j); }
    const T *row(int j) const { return memory.get() + offset(j); }
    T &operator()(int i, int j) { return row(j)[i]; }
    const T &operator()(int i, int j) const { return row(j)[i]; }

  private:
    static constexpr std::size_t lead = 64 / sizeof(T);
    static_assert(lead >= ghost_layers, "the ghosts left of a row fit into one line");
    static std::size_t round_up(int count)
    {
      return (static_cast<std::size_t>(count) + lead - 1) / lead * lead;
    }
    std::size_t size() const
    {
      return row_pitch * static_cast<std::size_t>(nodes_y + 2 * ghost_layers);
    }
    std::ptrdiff_t offset(int j) const
    {
      return (j + ghost_layers) * pitch() + static_cast<std::ptrdiff_t>(lead);
    }
    struct Free
    {
      void operator()(T *p) const { std::free(p); }
    };

    int nodes_x = 0, nodes_y = 0;
    std::size_t row_pitch = 0;
    std::unique_ptr<T[], Free> memory;
  };

  /// A vector at every node: two fields, in length per time where it is a velocity.
  struct Velocity
  {
    Velocity() = default;
    explicit Velocity(const Mesh &mesh) : x(mesh), y(mesh) {}
    Field<double> x, y;
  };

  /// How a field continues beyond a mirror wall: a scalar evenly; the normal component of a vector
  /// (and the normal derivative of a scalar) with changed sign.
  enum class Parity
  {
    even,
    odd_in_x,
    odd_in_y,
    odd_in_both
  };

  /// What the mirror image of a body carries beyond a symmetry side: the same scalar, or the angle
  /// to the mirror with changed sign. (At a side without flux both continue evenly.)
  enum class Image
  {
    scalar,
    angle
  };

  /// Fills the ghost layers of `field`: mirror (no flux, symmetry), wrap (periodic) or, beyond a
  /// fixed side, the point reflection 2 f(border) - f(mirror), which keeps the slope; so, too, for
  /// an angle (parity even) beyond a symmetry side. `parity` tells what derivative of a scalar or
  /// an angle the field is.
  template <class T>
  void fill_ghosts(Field<T> &field, const Mesh &mesh, Parity parity = Parity::even,
                   Image image = Image::scalar);

  /// Sum over all nodes of weight(i, j) times the field: the integral divided by the cell area.
} // namespace medium
