#include "medium/contour.h"

#include <unordered_map>

namespace medium
{
  namespace
  {
    /// Where the contour crosses one mesh line: along x at (i..i+1, j) or along y at (i, j..j+1).
    struct Crossing
    {
      Point at;
      long next = -1; // key of the crossing that the walk reaches through the cell on its way
      bool walked = false;
    };

    /// The active nodes, one more line at each side of the active rectangle where no node lies on
    /// it (with the value of the nearest node: no flux), and one outside that counts as liquid, so
    /// that every polyline closes.
    template <class T>
    class Lattice
    {
    public:
      Lattice(const Field<T> &field, const Mesh &mesh, Profile profile, const Box &active)
          : field(field), profile(profile)
      {
        for (int axis = 0; axis < 2; ++axis)
          place_lines(mesh, active, axis);
      }
      int lines(int axis) const { return static_cast<int>(place[axis].size()); }
      /// 1 for the solid nodes of a line along x.
      void mark_solid(int j, std::vector<std::uint8_t> &marks) const
      {
        std::fill(marks.begin(), marks.end(), std::uint8_t{0});
        if (outside(1, j))
          return;
        const T *const row = field.row(node[1][j]);
        for (std::size_t i = 1; i + 1 < node[0].size(); ++i)
          marks[i] = row[node[0][i]] > 0 ? 1 : 0;
      }
      double value(int i, int j) const
      {
        if (outside(0, i) || outside(1, j))
          return -1.;
        const double read = field(node[0][i], node[1][j]);
        return profile == Profile::straight ? read : straightened(read);
      }
      Point crossing(int i, int j, int axis) const
      {
        const int k = axis == 0 ? i : j, end = lines(axis) - 1;
        double s = 0.;
        if (k == 0 || k + 1 == end)
          s = k == 0 ? 1. : 0.; // on the border itself
        else
        {
          // Four node values along the line; next to the border the field continues evenly.
          double f[4];
          for (int step = -1; step <= 2; ++step)
          {
            const int line = mirrored(k + step, end);
            f[step + 1] = axis == 0 ? value(line, j) : value(i, line);
          }
          s = root_between(Cubic(f));
        }
        Point at(place[0][i], place[1][j]);
        at[axis] += s * (place[axis][k + 1] - place[axis][k]);
        return at;
      }

    private:
      bool outside(int axis, int line) const { return line == 0 || line == lines(axis) - 1; }
      /// A line of the stencil, reflected at the border lines 1 and end - 1.
      static int mirrored(int line, int end)
      {
        line = line < 1 ? 2 - line : line > end - 1 ? 2 * (end - 1) - line : line;
        return std::min(std::max(line, 1), end - 1);
      }
      void place_lines(const Mesh &mesh, const Box &active, int axis)
      {
        const double h = mesh.spacing[axis], low = active.lower[axis], high = active.upper[axis];
        const int last = mesh.nodes[axis] - 1;
        const double tolerance = 1e-9 * h;
        const auto position = [&](int k) { return mesh.lower[axis] + k * h; };
        int first = 0, final = last;
        while (first < last && position(first) < low - tolerance)
          ++first;
        while (final > first && position(final) > high + tolerance)
          --final;
        const auto add = [&](int k, double at)
        {
          node[axis].push_back(k);
          place[axis].push_back(at);
        };
        add(first, low);
        if (position(first) > low + tolerance)
          add(first, low);
        for (int k = first; k <= final; ++k)
          add(k, position(k));
        if (position(final) < high - tolerance)
          add(final, high);
        add(final, high);
      }

      const Field<T> &field;
      Profile profile;
      std::vector<int> node[2];
      std::vector<double> place[2];
    };

    /// Directed segments of one cell, solid on the left, as pairs of sides (bottom, right, top,
    /// left).
    int segments(unsigned corners, bool joined, int (&from)[2], int (&to)[2])
    {
      // corners: bit 0 (i, j), 1 (i+1, j), 2 (i+1, j+1), 3 (i, j+1) solid
      static constexpr int single[16][2] = {{-1, -1}, {0, 3}, {1, 0}, {1, 3},  {2, 1},   {-1, -1},
                                            {2, 0},   {2, 3}, {3, 2}, {0, 2},  {-1, -1}, {1, 2},
                                            {3, 1},   {0, 1}, {3, 0}, {-1, -1}};
      if (corners == 5)
      {
        from[0] = 0, to[0] = joined ? 1 : 3;
        from[1] = 2, to[1] = joined ? 3 : 1;
        return 2;
      }
      if (corners == 10)
      {
        from[0] = 1, to[0] = joined ? 2 : 0;
        from[1] = 3, to[1] = joined ? 0 : 2;
        return 2;
      }
      from[0] = single[corners][0], to[0] = single[corners][1];
      return from[0] < 0 ? 0 : 1;
    }

    template <class T>
    class Walk
    {
    public:
      explicit Walk(const Lattice<T> &lattice) : lattice(lattice)
      {
        const int columns = lattice.lines(0);
        std::vector<std::uint8_t> low(static_cast<std::size_t>(columns)), high(low);
        lattice.mark_solid(0, low);
        for (int j = 0; j + 1 < lattice.lines(1); ++j)
        {
          lattice.mark_solid(j + 1, high);
          for (int i = 0; i + 1 < columns;)
          {
            if (const int end = uniform_until(low, high, i); end > i)
            {
              i = end;
              continue;
            }
            const auto n = static_cast<std::size_t>(i);
            const unsigned corners = low[n] | low[n + 1] * 2u | high[n + 1] * 4u | high[n] * 8u;
            if (corners != 0 && corners != 15)
              add_cell(i, j, corners);
            ++i;
          }
          low.swap(high);
        }
      }
      std::vector<Polyline> polylines()
      {
        std::vector<Polyline> result;
        for (const long start : order)
        {
          Polyline line;
          for (long key = start; !crossings[key].walked; key = crossings[key].next)
          {
            crossings[key].walked = true;
            const Point &at = crossings[key].at;
            if (line.empty() || (at - line.back()).norm() > 0.)
              line.push_back(at);
          }
          while (line.size() > 1 && (line.front() - line.back()).norm() == 0.)
            line.pop_back();
          if (line.size() > 2)
            result.push_back(std::move(line));
        }
        return result;
      }

    private:
      /// Most of the domain is one or the other: cells from i on that are all solid or all liquid,
      /// sixteen at a time. Returns i where there are none.
      static int uniform_until(const std::vector<std::uint8_t> &low,
                               const std::vector<std::uint8_t> &high, int i)
      {
        constexpr int length = 16;
        const int last = static_cast<int>(low.size()) - 1; // nodes, one more than cells
        for (; i + length <= last; i += length)
        {
          unsigned sum = 0;
          for (int k = 0; k <= length; ++k)
            sum += low[static_cast<std::size_t>(i + k)] + high[static_cast<std::size_t>(i + k)];
          if (sum != 0 && sum != 2 * (length + 1))
            break;
        }
        return i;
      }
      long key(int i, int j, int side) const
      {
        const int x = i + (side == 1), y = j + (side == 2), axis = side % 2;
        return 2 * (static_cast<long>(y) * lattice.lines(0) + x) + axis;
      }
      void add_cell(int i, int j, unsigned corners)
      {
        const double mean = lattice.value(i, j) + lattice.value(i + 1, j) +
                            lattice.value(i, j + 1) + lattice.value(i + 1, j + 1);
        int from[2], to[2];
        const int count = segments(corners, mean > 0., from, to);
        for (int n = 0; n < count; ++n)
        {
          const long start = key(i, j, from[n]);
          Crossing &crossing = crossings[start];
          crossing.at = lattice.crossing(i + (from[n] == 1), j + (from[n] == 2), from[n] % 2);
          crossing.next = key(i, j, to[n]);
          order.push_back(start);
        }
      }

      const Lattice<T> &lattice;
      std::unordered_map<long, Crossing> crossings;
      std::vector<long> order; // the polylines start in the order of the cells
    };
  } // namespace

  template <class T>
  std::vector<Polyline> contour(const Field<T> &field, const Mesh &mesh, Profile profile,
                                const std::optional<Box> &active)
  {
    const Lattice<T> lattice(field, mesh, profile, active.value_or(extent(mesh)));
    return Walk<T>(lattice).polylines();
  }

  template std::vector<Polyline> contour(const Field<double> &, const Mesh &, Profile,
                                         const std::optional<Box> &);
  template std::vector<Polyline> contour(const Field<float> &, const Mesh &, Profile,
                                         const std::optional<Box> &);

  double enclosed_area(const std::vector<Polyline> &polylines)
  {
    double twice = 0.;
    for (const Polyline &line : polylines)
      for (std::size_t k = 0; k < line.size(); ++k)
      {
        const Point a = line[k] - line[0], b = line[(k + 1) % line.size()] - line[0];
        twice += a[0] * b[1] - a[1] * b[0];
      }
    return 0.5 * twice;
  }

  double interface_length(const std::vector<Polyline> &polylines, const Box &inner)
  {
    const double tolerance = 1e-9 * (inner.upper - inner.lower).norm();
    double length = 0.;
    for (const Polyline &line : polylines)
      for (std::size_t k = 0; k < line.size(); ++k)
      {
        const Point &a = line[k], &b = line[(k + 1) % line.size()];
        bool on_border = false;
        for (int axis = 0; axis < 2; ++axis)
          for (const double side : {inner.lower[axis], inner.upper[axis]})
            on_border = on_border || (std::abs(a[axis] - side) < tolerance &&
                                      std::abs(b[axis] - side) < tolerance);
        length += on_border ? 0. : (b - a).norm();
      }
    return length;
  }

  Box extent(const Mesh &mesh)
  {
    return {mesh.lower, mesh.position(mesh.nodes[0] - 1, mesh.nodes[1] - 1)};
  }
} // namespace medium
