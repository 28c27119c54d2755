#include "medium/cuts.h"

#include <cmath>

namespace medium
{
  namespace
  {
    Edge low_edge(int axis)
    {
      return axis == 0 ? Edge::left : Edge::bottom;
    }
    Edge high_edge(int axis)
    {
      return axis == 0 ? Edge::right : Edge::top;
    }

    /// Weights of the lines last, last - 1, last - 2 (counted away from the wall) in the k-th line
    /// behind the cut: what stands at the mirror image of that line.
    std::array<double, 3> continuation(double gap, int k, bool odd)
    {
      const double image = 2. * gap - k; // towards the wall from `last`
      if (image >= 0.) // between it and the wall: nothing but the wall's condition
      {
        const double q = k * (k - 2. * gap) / (1. + 2. * gap);
        return odd ? std::array<double, 3>{(gap - k) / gap, 0., 0.}
                   : std::array<double, 3>{1. - q, q, 0.};
      }
      const double r = -image, sign = odd ? -1. : 1.;
      return {sign * 0.5 * (1. - r) * (2. - r), sign * r * (2. - r), -sign * 0.5 * r * (1. - r)};
    }

    /// All lines behind one cut. `at(line, n)`: element n of a line; every line has `length` of
    /// them.
    template <class T, class At>
    void fill_lines(const Cut &cut, int outward, int count, int length, bool odd, At at)
    {
      const int behind = outward > 0 ? count - 1 - cut.last : cut.last;
      for (int k = 1; k <= behind; ++k)
      {
        const int line = cut.last + outward * k;
        const std::array<double, 3> c = continuation(cut.gap, std::min(k, ghost_layers), odd);
        for (int n = 0; n < length; ++n)
          at(line, n) = k > ghost_layers ? (odd ? T(0) : at(line - outward, n))
                                         : static_cast<T>(c[0] * at(cut.last, n) +
                                                          c[1] * at(cut.last - outward, n) +
                                                          c[2] * at(cut.last - 2 * outward, n));
      }
    }
  } // namespace

  int Cuts::first(int axis) const
  {
    const auto &cut = at(low_edge(axis));
    return cut ? cut->last : 0;
  }

  int Cuts::end(int axis, int count) const
  {
    const auto &cut = at(high_edge(axis));
    return cut ? cut->last + 1 : count;
  }

  double Cuts::size(int axis, int line, int count) const
  {
    const auto &low = at(low_edge(axis)), &high = at(high_edge(axis));
    if (line < first(axis) || line >= end(axis, count))
      return 0.;
    if (low && line == low->last)
      return low->size();
    if (high && line == high->last)
      return high->size();
    return line == 0 || line == count - 1 ? 0.5 : 1.;
  }

  Box active_box(const Cuts &cuts, const Mesh &mesh)
  {
    Box box{mesh.lower, mesh.position(mesh.nodes[0] - 1, mesh.nodes[1] - 1)};
    for (int axis = 0; axis < 2; ++axis)
    {
      if (const auto &cut = cuts.at(low_edge(axis)))
        box.lower[axis] = mesh.lower[axis] + (cut->last - cut->gap) * mesh.spacing[axis];
      if (const auto &cut = cuts.at(high_edge(axis)))
        box.upper[axis] = mesh.lower[axis] + (cut->last + cut->gap) * mesh.spacing[axis];
    }
    return box;
  }

  template <class T>
  void fill_behind(Field<T> &field, const Cuts &cuts, const Mesh &mesh, Parity parity, Image image)
  {
    const bool odd[2] = {parity == Parity::odd_in_x || parity == Parity::odd_in_both,
                         parity == Parity::odd_in_y || parity == Parity::odd_in_both};
    for (int axis = 0; axis < 2; ++axis)
      for (const bool high : {false, true})
        if (const auto &cut = cuts.at(high ? high_edge(axis) : low_edge(axis)))
          fill_lines<T>(*cut, high ? 1 : -1, mesh.nodes[axis], mesh.nodes[1 - axis], odd[axis],
                        [&](int line, int n) -> T &
                        { return axis == 0 ? field(line, n) : field(n, line); });
    fill_ghosts(field, mesh, parity, image);
  }

  template void fill_behind(Field<double> &, const Cuts &, const Mesh &, Parity, Image);
  template void fill_behind(Field<float> &, const Cuts &, const Mesh &, Parity, Image);

  template <class T>
  void fill_next_row(Field<T> &field, const Cut &cut, Edge edge, int nx)
  {
    const int outward = edge == Edge::top ? 1 : -1;
    const T share = static_cast<T>(cut.share());
    const T *last = field.row(cut.last), *before = field.row(cut.last - outward);
    T *behind = field.row(cut.last + outward);
    for (int i = -1; i <= nx; ++i)
      behind[i] = last[i] + share * (before[i] - last[i]);
  }

  template void fill_next_row(Field<double> &, const Cut &, Edge, int);
  template void fill_next_row(Field<float> &, const Cut &, Edge, int);
} // namespace medium
