#include "medium/sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medium
{
  namespace
  {
    constexpr int lanes = 8;

    /// A sum and what its additions have rounded off (Knuth's exact sum of two, without a branch).
    struct Compensated
    {
      double sum = 0., lost = 0.;
      void add(const double term)
      {
        const double next = sum + term, part = next - sum;
        lost += (sum - (next - part)) + (term - part);
        sum = next;
      }
      void add(const Compensated &other)
      {
        add(other.sum);
        lost += other.lost;
      }
      double value() const { return sum + lost; }
    };

    /// Widths and heights that nodes own, in cells; between `first` and `end` of each axis.
    struct Owned
    {
      int first[2], end[2];
      std::vector<double> size[2];
      Owned(const Mesh &mesh, const Cuts &cuts)
      {
        for (int axis = 0; axis < 2; ++axis)
        {
          const int count = mesh.nodes[static_cast<std::size_t>(axis)];
          first[axis] = cuts.first(axis), end[axis] = cuts.end(axis, count);
          for (int k = first[axis]; k < end[axis]; ++k)
            size[axis].push_back(cuts.size(axis, k, count));
        }
      }
      int columns() const { return end[0] - first[0]; }
      int rows() const { return end[1] - first[1]; }
    };

    /// Sum of term(i, width) over a row, in as many lanes as a vector has.
    template <class Term>
    Compensated row_sum(const Owned &owned, const Term &term)
    {
      const double *const width = owned.size[0].data();
      const int count = owned.columns(), even = count - count % lanes;
      double sum[lanes] = {}, lost[lanes] = {};
      for (int i = 0; i < even; i += lanes)
#pragma omp simd
        for (int k = 0; k < lanes; ++k)
        {
          Compensated lane{sum[k], lost[k]};
          lane.add(term(i + k, width[i + k]));
          sum[k] = lane.sum, lost[k] = lane.lost;
        }
      Compensated total;
      for (int k = 0; k < lanes; ++k)
        total.add({sum[k], lost[k]});
      for (int i = even; i < count; ++i)
        total.add(term(i, width[i]));
      return total;
    }

    /// Sum over the rows of height times row(j).
    template <class Row>
    double sum_of_rows(const Owned &owned, const Row &row)
    {
      std::vector<Compensated> rows(static_cast<std::size_t>(owned.rows()));
#pragma omp parallel for schedule(static)
      for (int j = 0; j < owned.rows(); ++j)
        rows[static_cast<std::size_t>(j)] = row(j, owned.size[1][static_cast<std::size_t>(j)]);
      Compensated total;
      for (const Compensated &one : rows)
        total.add(one);
      return total.value();
    }
  } // namespace

  double weighted_sum(const Field<double> &field, const Mesh &mesh, const Cuts &cuts)
  {
    const Owned owned(mesh, cuts);
    return sum_of_rows(owned,
                       [&](const int j, const double height)
                       {
                         const double *const f = field.row(owned.first[1] + j) + owned.first[0];
                         return row_sum(owned, [&](const int i, const double width)
                                        { return height * width * f[i]; });
                       });
  }

  Statistics statistics_of(const Field<double> &field, const Mesh &mesh, const Cuts &cuts)
  {
    const Owned owned(mesh, cuts);
    double area = 0., width_sum = 0.;
    for (const double width : owned.size[0])
      width_sum += width;
    for (const double height : owned.size[1])
      area += height * width_sum;
    Statistics statistics;
    statistics.mean = weighted_sum(field, mesh, cuts) / area;
    double low = std::numeric_limits<double>::infinity(), high = -low;
#pragma omp parallel for schedule(static) reduction(min : low) reduction(max : high)
    for (int j = owned.first[1]; j < owned.end[1]; ++j)
    {
      const double *const f = field.row(j);
#pragma omp simd reduction(min : low) reduction(max : high)
      for (int i = owned.first[0]; i < owned.end[0]; ++i)
        low = std::min(low, f[i]), high = std::max(high, f[i]);
    }
    statistics.min = low, statistics.max = high;
    statistics.variance = sum_of_rows(owned,
                                      [&](const int j, const double height)
                                      {
                                        const double *const f =
                                            field.row(owned.first[1] + j) + owned.first[0];
                                        return row_sum(owned,
                                                       [&](const int i, const double width)
                                                       {
                                                         const double off = f[i] - statistics.mean;
                                                         return height * width * off * off;
                                                       });
                                      }) /
                          area;
    return statistics;
  }
} // namespace medium
