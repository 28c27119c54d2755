#include "medium/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <omp.h>

#include "medium/contour_pieces.h"
#include "medium/contour_tiles.h"

namespace medium
{
  namespace
  {
    /// The pieces again, one period away, where that can be nearer.
    void add_periodic_images(Distance &distance, const Mesh &mesh)
    {
      bool sorted = true;
      for (int axis = 0; axis < 2; ++axis)
      {
        if (mesh.side(axis == 0 ? Edge::left : Edge::bottom) != Boundary::periodic)
          continue;
        const double length = (mesh.nodes[axis] - 1) * mesh.spacing[axis];
        const std::size_t count = distance.pieces.size();
        for (std::size_t k = 0; k < count; ++k)
        {
          ContourPiece image = distance.pieces[k];
          double &at = axis == 0 ? image.x : image.y;
          const double inside = at - mesh.lower[axis];
          if (inside <= distance.band)
            at += length;
          else if (inside >= length - distance.band)
            at -= length;
          else
            continue;
          distance.pieces.push_back(image);
          sorted = false;
        }
      }
      if (!sorted)
        std::stable_sort(distance.pieces.begin(), distance.pieces.end(),
                         [](const auto &a, const auto &b) { return a.y < b.y; });
    }

    /// Distance to the arc of the osculating circle, or to a straight segment where no circle
    /// fits, for one row of a tile from `start` of the scratch. `longest`: the larger spacing.
    void measure_line(Claims &claims, std::ptrdiff_t start, double reach, double longest)
    {
      const double *square = claims.square.data() + start, *above = claims.above.data() + start,
                   *aside = claims.aside.data() + start, *bends = claims.curvature.data() + start;
      const int *owner = claims.owner.data() + start;
      double *size = claims.size.data() + start, *offset = claims.offset.data() + start;
      int misfits = 0;
#pragma omp simd reduction(+ : misfits)
      for (int n = 0; n < Tiles::width; ++n)
      {
        const double m = above[n], s = aside[n], curvature = bends[n];
        const double under = 1. - 2. * curvature * m + curvature * curvature * square[n];
        const double root = std::sqrt(under > 0.0025 ? under : 0.0025), along = s / root;
        const double arc = std::abs(2. * m - curvature * square[n]) / (1. + root);
        const bool owned = owner[n] >= 0;
        misfits += owned & ((under <= 0.0025) | (std::abs(along) > longest)) ? 1 : 0;
        size[n] = owned & (arc < reach) ? arc : reach;
        offset[n] = along;
      }
      for (int n = 0; misfits > 0 && n < Tiles::width; ++n)
      {
        const double m = above[n], s = aside[n], curvature = bends[n];
        const double under = 1. - 2. * curvature * m + curvature * curvature * square[n];
        if (owner[n] < 0 || (under > 0.0025 && std::abs(offset[n]) <= longest))
          continue;
        offset[n] = std::clamp(s, -0.5 * longest, 0.5 * longest);
        size[n] = std::min(reach, std::hypot(s - offset[n], m));
      }
    }

    /// Whether distances of neighbours differ by more than their spacing and a quarter: there a
    /// node has been left out. `below`: the row before, or the same.
    bool jumps(const double *size, const double *below, int nodes, double ratio)
    {
      constexpr double slack = 0.25;
      int count = 0;
#pragma omp simd reduction(| : count)
      for (int n = 1; n < nodes; ++n)
        count |= (std::abs(size[n] - size[n - 1]) > 1. + slack) |
                 (std::abs(size[n] - below[n]) > ratio + slack);
      return count != 0;
    }

    /// Distances at all active tiles of a row; false where they jump.
    bool measure_sizes(Claims &claims, const Distance &distance, const Mesh &mesh, int row)
    {
      const Tiles &tiles = distance.tiles;
      const double h = mesh.spacing[0], ratio = mesh.spacing[1] / h, reach = distance.band / h;
      bool smooth = true;
      for (int column = 0; column < tiles.columns; ++column)
      {
        if (tiles.at(column, row) != Activity::active)
          continue;
        const int nodes = tiles.end_node(column) - tiles.first_node(column);
        for (int j = 0; j < tiles.end_row(row) - tiles.first_row(row); ++j)
        {
          const std::ptrdiff_t start =
              static_cast<std::ptrdiff_t>(j) * claims.pitch + tiles.first_node(column);
          measure_line(claims, start, reach, std::max(1., ratio));
          const double *size = claims.size.data() + start;
          smooth = !jumps(size, j == 0 ? size : size - claims.pitch, nodes, ratio) && smooth;
        }
      }
      return smooth;
    }

    /// One row of a tile, [i0, i1) of row j, from `start` of the scratch to psi, piece and offset.
    struct Segment
    {
      int j, i0, i1;
      std::ptrdiff_t start;
    };
    template <class T>
    void write(Distance &distance, const Claims &claims, const T *phi, const Segment &at,
               double unit)
    {
      const double band = distance.band;
      double *psi = distance.psi.row(at.j);
      int *piece = distance.piece.row(at.j);
      double *offset = distance.offset.row(at.j);
      const double *size = claims.size.data() + at.start - at.i0,
                   *along = claims.offset.data() + at.start - at.i0;
      const int *owner = claims.owner.data() + at.start - at.i0;
      const double reach = band / unit;
#pragma omp simd
      for (int i = at.i0; i < at.i1; ++i)
      {
        const double kept = size[i] < reach ? size[i] * unit : band;
        psi[i] = phi[i] > 0 ? kept : -kept;
        piece[i] = size[i] < reach ? owner[i] : -1;
        offset[i] = along[i] * unit;
      }
    }

    /// All nodes of a tile that the band has left.
    template <class T>
    void leave_tile(Distance &distance, const T *phi, int j, int i0, int i1)
    {
      for (int i = i0; i < i1; ++i)
        distance.psi(i, j) = phi[i] > 0 ? distance.band : -distance.band;
      std::fill(distance.piece.row(j) + i0, distance.piece.row(j) + i1, -1);
    }

    /// Pieces that can reach the rows [j0, j1), each of which claims its nodes there.
    void claim_rows(Claims &claims, const Distance &distance, const std::vector<Strip> &strips,
                    const Mesh &mesh, int row, Reach how)
    {
      const int reach = static_cast<int>(std::ceil(distance.band / mesh.spacing[1])) + 1;
      const int rows = distance.psi.nodes(1), count = static_cast<int>(distance.pieces.size()),
                j0 = distance.tiles.first_row(row), j1 = distance.tiles.end_row(row);
      const auto first = [&](int j) { return distance.first_of_row[static_cast<std::size_t>(j)]; };
      const int begin = j0 - reach <= 0 ? 0 : first(j0 - reach),
                end = j1 + reach >= rows ? count : first(j1 + reach);
      forget(claims, distance.tiles, row);
      claim(claims, distance, strips, mesh, row, {begin, end, how});
    }

    template <class T>
    void measure_tile_row(Distance &distance, Claims &claims, const std::vector<Strip> &strips,
                          const Tiles &before, const Field<T> &phi, const Mesh &mesh, int row)
    {
      const Tiles &tiles = distance.tiles;
      bool any = false;
      for (int column = 0; column < tiles.columns; ++column)
        any = any || tiles.at(column, row) == Activity::active;
      if (any)
      {
        claim_rows(claims, distance, strips, mesh, row, Reach::strips);
        if (!measure_sizes(claims, distance, mesh, row))
        {
          claim_rows(claims, distance, strips, mesh, row, Reach::everything);
          measure_sizes(claims, distance, mesh, row);
        }
      }
      const int j0 = tiles.first_row(row), j1 = tiles.end_row(row);
      for (int column = 0; column < tiles.columns; ++column)
      {
        const int i0 = tiles.first_node(column), i1 = tiles.end_node(column);
        if (tiles.at(column, row) == Activity::active)
          for (int j = j0; j < j1; ++j)
            write(distance, claims, phi.row(j),
                  {j, i0, i1, static_cast<std::ptrdiff_t>(j - j0) * claims.pitch + i0},
                  mesh.spacing[0]);
        else if (before.at(column, row) == Activity::active)
          for (int j = j0; j < j1; ++j)
            leave_tile(distance, phi.row(j), j, i0, i1);
      }
    }

    template <class T>
    void measure_in(Distance &distance, const Field<T> &phi, const Mesh &mesh, const Tiles &where)
    {
      distance.pieces = contour_pieces(phi, mesh, where);
      add_periodic_images(distance, mesh);
      const int rows = mesh.nodes[1];
      distance.first_of_row.assign(static_cast<std::size_t>(rows) + 1, 0);
      for (int j = 0, k = 0; j <= rows; ++j)
      {
        const double y = mesh.lower[1] + j * mesh.spacing[1];
        while (k < static_cast<int>(distance.pieces.size()) &&
               distance.pieces[static_cast<std::size_t>(k)].y < y)
          ++k;
        distance.first_of_row[static_cast<std::size_t>(j)] = k;
      }
      const Tiles before = distance.tiles;
      mark_tiles(distance, mesh);
      if (distance.pieces.empty()) // a place to read from where no piece owns a node
        distance.pieces.push_back({mesh.lower[0], mesh.lower[1], 1., 0., 0.});
      const std::vector<Strip> strips = strips_of(distance, mesh);
      const auto threads = static_cast<std::size_t>(omp_get_max_threads());
      while (distance.claims.size() < threads)
        distance.claims.emplace_back(mesh);
#pragma omp parallel for schedule(dynamic, 2)
      for (int row = 0; row < distance.tiles.rows; ++row)
        measure_tile_row(distance, distance.claims[static_cast<std::size_t>(omp_get_thread_num())],
                         strips, before, phi, mesh, row);
    }
  } // namespace

  Distance::Distance(const Mesh &mesh, double band_cells)
      : band(band_cells * std::max(mesh.spacing[0], mesh.spacing[1])), psi(mesh), piece(mesh, -1),
        offset(mesh), tiles(mesh), close(mesh)
  {
    if (!(band_cells >= 3.))
    {
      std::ostringstream text;
      text << "the band of the distance is " << band_cells
           << " cells wide; it must be at least 3, because cells cut by the contour and their "
              "neighbours need a distance";
      throw std::invalid_argument(text.str());
    }
  }

  template <class T>
  void compute_distance(Distance &distance, const Field<T> &phi, const Mesh &mesh)
  {
    measure_in(distance, phi, mesh, Tiles(mesh));
  }

  template <class T>
  void update_distance(Distance &distance, const Field<T> &phi, const Mesh &mesh)
  {
    const Tiles where = distance.close;
    measure_in(distance, phi, mesh, where);
  }

  template void compute_distance(Distance &, const Field<double> &, const Mesh &);
  template void compute_distance(Distance &, const Field<float> &, const Mesh &);
  template void update_distance(Distance &, const Field<double> &, const Mesh &);
  template void update_distance(Distance &, const Field<float> &, const Mesh &);

  Point closest_point(const Distance &distance, int i, int j)
  {
    const ContourPiece &piece = distance.pieces[static_cast<std::size_t>(distance.piece(i, j))];
    const double s = distance.offset(i, j), curvature = 0.5 * piece.curvature * s * s;
    return {piece.x - s * piece.normal_y + curvature * piece.normal_x,
            piece.y + s * piece.normal_x + curvature * piece.normal_y};
  }
} // namespace medium
