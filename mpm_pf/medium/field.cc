#include "medium/field.h"

#include <cmath>
#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace medium
{
  void *allocate_lines(std::size_t bytes)
  {
    constexpr std::size_t line = 64, page = 4096, large = std::size_t{4} << 20;
    void *memory = std::aligned_alloc(line, (bytes + line - 1) / line * line);
    if (!memory)
      throw std::bad_alloc();
#ifdef __linux__
    if (bytes >= large) // only advice: without huge pages all is as before
    {
      const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
      madvise(static_cast<char *>(memory) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
    }
#endif
    return memory;
  }

  namespace
  {
    /// Value beyond a border: from the value at its source and, for a fixed side, at the border.
    template <class T>
    T continued(T source, T border, Boundary boundary, bool odd, Image image)
    {
      switch (boundary)
      {
      case Boundary::periodic:
        return source;
      case Boundary::fixed:
        return 2 * border - source;
      case Boundary::symmetry:
        if (image == Image::angle)
          return odd ? source : 2 * border - source;
        break;
      case Boundary::no_flux:
        break;
      }
      return odd ? -source : source;
    }

    template <class T>
    void fill_row_ends(T *row, int count, const Mesh &mesh, bool odd, Image image)
    {
      const Boundary left = mesh.side(Edge::left), right = mesh.side(Edge::right);
      for (int layer = 1; layer <= ghost_layers; ++layer)
      {
        const int low = -layer, high = count - 1 + layer;
        row[low] = continued(row[source_index(low, count, left, right)], row[0], left, odd, image);
        row[high] = continued(row[source_index(high, count, left, right)], row[count - 1], right,
                              odd, image);
      }
    }
  } // namespace

  template <class T>
  void fill_ghosts(Field<T> &field, const Mesh &mesh, Parity parity, Image image)
  {
    const int nx = mesh.nodes[0], ny = mesh.nodes[1];
    const bool odd_x = parity == Parity::odd_in_x || parity == Parity::odd_in_both;
    const bool odd_y = parity == Parity::odd_in_y || parity == Parity::odd_in_both;
    for (int j = 0; j < ny; ++j)
      fill_row_ends(field.row(j), nx, mesh, odd_x, image);
    const Boundary bottom = mesh.side(Edge::bottom), top = mesh.side(Edge::top);
    for (int layer = 1; layer <= ghost_layers; ++layer)
      for (const bool low : {true, false})
      {
        const int j = low ? -layer : ny - 1 + layer;
        const Boundary boundary = low ? bottom : top;
        const T *source = field.row(source_index(j, ny, bottom, top));
        const T *border = field.row(low ? 0 : ny - 1);
        T *ghost = field.row(j);
        for (int i = -ghost_layers; i < nx + ghost_layers; ++i)
          ghost[i] = continued(source[i], border[i], boundary, odd_y, image);
      }
  }

  template void fill_ghosts(Field<double> &, const Mesh &, Parity, Image);
  template void fill_ghosts(Field<float> &, const Mesh &, Parity, Image);
} // namespace medium
