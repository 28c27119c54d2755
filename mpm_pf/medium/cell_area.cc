#include "medium/cell_area.h"

#include <cmath>

namespace medium
{
  namespace
  {
    double twice_area(const ConvexPolygon &polygon)
    {
      double twice = 0.;
      for (int k = 1; k + 1 < polygon.count; ++k)
      {
        const Point a = polygon.vertex[k] - polygon.vertex[0];
        const Point b = polygon.vertex[k + 1] - polygon.vertex[0];
        twice += a[0] * b[1] - a[1] * b[0];
      }
      return twice;
    }

    // What of the polygon lies where side (x[axis] - bound) >= 0.
    ConvexPolygon cut_off(const ConvexPolygon &polygon, const int axis, const double bound,
                          const double side)
    {
      ConvexPolygon kept;
      for (int k = 0; k < polygon.count; ++k)
      {
        const Point &a = polygon.vertex[k], &b = polygon.vertex[(k + 1) % polygon.count];
        const double from = side * (a[axis] - bound), to = side * (b[axis] - bound);
        if (from >= 0.)
          kept.add(a);
        if ((from > 0. && to < 0.) || (from < 0. && to > 0.))
        {
          Point at = a + from / (from - to) * (b - a);
          at[axis] = bound;
          kept.add(at);
        }
      }
      return kept;
    }
  } // namespace

  double area(const ConvexPolygon &polygon)
  {
    return 0.5 * twice_area(polygon);
  }

  Point centroid(const ConvexPolygon &polygon)
  {
    Point sum = Point::Zero(), mean = Point::Zero();
    double twice = 0.;
    for (int k = 0; k < polygon.count; ++k)
      mean += polygon.vertex[k] / polygon.count;
    for (int k = 1; k + 1 < polygon.count; ++k)
    {
      const Point a = polygon.vertex[k] - polygon.vertex[0];
      const Point b = polygon.vertex[k + 1] - polygon.vertex[0];
      const double part = a[0] * b[1] - a[1] * b[0];
      sum += part / 3. * (a + b), twice += part;
    }
    return twice > 0. ? Point(polygon.vertex[0] + sum / twice) : mean;
  }

  ConvexPolygon clip(const ConvexPolygon &polygon, const scene::Box &box)
  {
    ConvexPolygon kept = polygon;
    for (int axis = 0; axis < 2; ++axis)
    {
      kept = cut_off(kept, axis, box.lower[axis], 1.);
      kept = cut_off(kept, axis, box.upper[axis], -1.);
    }
    return kept;
  }

  double CellPart::area() const
  {
    double sum = 0.;
    for (int k = 0; k < pieces; ++k)
      sum += medium::area(piece[k]);
    return sum;
  }

  CellAreas::CellAreas(const Field<double> &phi, const Mesh &mesh,
                       const std::optional<scene::Box> &active)
      : field(phi)
  {
    for (int k = 0; k < 2; ++k)
    {
      Axis &axis = axes[k];
      axis.lower = mesh.lower[k], axis.spacing = mesh.spacing[k];
      axis.last = mesh.nodes[k] - 1;
      const double end = axis.lower + axis.last * axis.spacing, small = 1e-9 * axis.spacing;
      axis.low = active ? std::max(active->lower[k], axis.lower) : axis.lower;
      axis.high = active ? std::min(active->upper[k], end) : end;
      const auto at = [&](const int i) { return axis.lower + i * axis.spacing; };
      while (axis.first < axis.last && at(axis.first) < axis.low - small)
        ++axis.first;
      while (axis.last > axis.first && at(axis.last) > axis.high + small)
        --axis.last;
      axis.cut_low = at(axis.first) > axis.low + small;
      axis.cut_high = at(axis.last) < axis.high - small;
    }
  }

  // The wall's own line, where it cuts a cell, counts as one more node with the value of the
  // nearest; beyond, the mesh is mirrored in it.
  int CellAreas::Axis::source(const int node) const
  {
    int found = node;
    if (node < first)
      found = cut_low ? std::max(first, 2 * first - node - 2) : 2 * first - node;
    else if (node > last)
      found = cut_high ? std::min(last, 2 * last - node + 2) : 2 * last - node;
    return std::min(std::max(found, first), last);
  }

  double CellAreas::Axis::position(const int node) const
  {
    return node < first ? low : node > last ? high : lower + node * spacing;
  }

  scene::Box CellAreas::box(const int i, const int j) const
  {
    return {corner(i, j), corner(i + 1, j + 1)};
  }

  double CellAreas::whole(const int i, const int j) const
  {
    for (int axis = 0; axis < 2; ++axis)
      if (const int cell = axis == 0 ? i : j; cell < first_cell(axis) || cell >= end_cell(axis))
        return 0.;
    if (!cut(0, i) && !cut(1, j))
      return axes[0].spacing * axes[1].spacing;
    const scene::Box cell = box(i, j);
    return (cell.upper - cell.lower).prod();
  }

  unsigned CellAreas::corners(const int i, const int j) const
  {
    return (node(i, j) > 0. ? 1u : 0u) | (node(i + 1, j) > 0. ? 2u : 0u) |
           (node(i + 1, j + 1) > 0. ? 4u : 0u) | (node(i, j + 1) > 0. ? 8u : 0u);
  }

  // On the mesh line from node (i, j) to the next along the axis.
  Point CellAreas::crossing(const int i, const int j, const int axis) const
  {
    double f[4];
    for (int k = 0; k < 4; ++k)
      f[k] = straightened(axis == 0 ? node(i - 1 + k, j) : node(i, j - 1 + k));
    const Point from = corner(i, j), to = axis == 0 ? corner(i + 1, j) : corner(i, j + 1);
    return from + root_between(Cubic(f)) * (to - from);
  }

  CellPart CellAreas::part(const int i, const int j) const
  {
    CellPart found;
    const unsigned solid = corners(i, j);
    if (solid == 0u || whole(i, j) <= 0.)
      return found;
    const int di[4] = {0, 1, 1, 0}, dj[4] = {0, 0, 1, 1};
    const int side_i[4] = {0, 1, 0, 0}, side_j[4] = {0, 0, 1, 0}; // first node of side k
    const auto is_solid = [&](const int k) { return (solid >> (k % 4) & 1u) != 0u; };
    std::array<Point, 4> cross;
    for (int k = 0; k < 4; ++k)
      if (is_solid(k) != is_solid(k + 1))
        cross[k] = crossing(i + side_i[k], j + side_j[k], k % 2);
    double mean = 0.;
    for (int k = 0; k < 4; ++k)
      mean += straightened(node(i + di[k], j + dj[k]));
    if ((solid == 5u || solid == 10u) && !(mean > 0.))
    {
      for (int k = solid == 5u ? 0 : 1; k < 4; k += 2)
      {
        ConvexPolygon &piece = found.piece[found.pieces++];
        piece.add(corner(i + di[k], j + dj[k])), piece.add(cross[k]), piece.add(cross[(k + 3) % 4]);
        found.segment[found.segments++] = {cross[k], cross[(k + 3) % 4]};
      }
      return found;
    }
    ConvexPolygon &piece = found.piece[found.pieces++];
    for (int k = 0; k < 4; ++k)
    {
      if (is_solid(k))
        piece.add(corner(i + di[k], j + dj[k]));
      if (is_solid(k) == is_solid(k + 1))
        continue;
      piece.add(cross[k]);
      if (!is_solid(
              k)) // the contour leads back into the solid here: it came out where last crossed
        continue;
      int back = k + 1;
      while (is_solid(back) == is_solid(back + 1))
        ++back;
      found.segment[found.segments++] = {cross[k], cross[back % 4]};
    }
    return found;
  }

  double CellAreas::area(const int i, const int j) const
  {
    const unsigned solid = corners(i, j);
    return solid == 0u ? 0. : solid == 15u ? whole(i, j) : part(i, j).area();
  }

  double CellAreas::value(const Point &x) const
  {
    double s[2];
    int cell[2];
    for (int k = 0; k < 2; ++k)
    {
      const double a = (x[k] - axes[k].lower) / axes[k].spacing;
      cell[k] = static_cast<int>(std::floor(a)), s[k] = a - cell[k];
    }
    const int i = cell[0], j = cell[1];
    return (1. - s[1]) * ((1. - s[0]) * node(i, j) + s[0] * node(i + 1, j)) +
           s[1] * ((1. - s[0]) * node(i, j + 1) + s[0] * node(i + 1, j + 1));
  }
} // namespace medium
