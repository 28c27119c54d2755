// Gradients brought up to date with whatever changed a field since its last advection, row by row.
//
//   g <- g + centred difference of (f - last)
//
// Three rows of them are all that an upwind cell needs: they are made when the sweep over rows
// comes to them and never leave the cache.
#pragma once

#include <vector>

#include "medium/cip.h"

namespace medium
{
  /// Rows swept by one thread at a time; each such block makes two rows that its neighbours make
  /// too.
  inline constexpr int rows_per_block = 64;

  class CurrentGradients
  {
  public:
    CurrentGradients(const CipFields &, const Mesh &);

    /// Makes row j (-1 ... rows), from node -1 to the node beyond the last. Rows in their order.
    void compute_row(int j);

    /// The last three rows computed; xy only with the mixed derivative.
    const double *x(int age) const { return row(0, age); }
    const double *y(int age) const { return row(1, age); }
    const double *xy(int age) const { return row(2, age); }

  private:
    const double *row(int kind, int age) const
    {
      return memory.data() + offset(kind, (newest - age + 3) % 3);
    }
    std::size_t offset(int kind, int slot) const
    {
      return static_cast<std::size_t>(3 * kind + slot) * pitch + lead;
    }

    static constexpr std::size_t lead = 8; // room for node -1
    CipFields fields;
    int count, newest = 0;
    double per_x, per_y;
    std::size_t pitch;
    std::vector<double> memory;
  };

  /// Sweeps `do_row(gradients, j)` over all rows in blocks, gradients holding rows j - 1 (age 2), j
  /// and j + 1 (age 0). Returns the largest value that do_row returned.
  template <class DoRow>
  double sweep_rows(const CipFields &fields, const Mesh &mesh, const DoRow &do_row)
  {
    const int rows = mesh.nodes[1], blocks = (rows + rows_per_block - 1) / rows_per_block;
    double largest = 0.;
#pragma omp parallel for schedule(static) reduction(max : largest)
    for (int block = 0; block < blocks; ++block)
    {
      const int first = block * rows_per_block, end = std::min(first + rows_per_block, rows);
      CurrentGradients gradients(fields, mesh);
      gradients.compute_row(first - 1);
      gradients.compute_row(first);
      for (int j = first; j < end; ++j)
      {
        gradients.compute_row(j + 1);
        largest = std::max(largest, do_row(gradients, j));
      }
    }
    return largest;
  }
} // namespace medium
