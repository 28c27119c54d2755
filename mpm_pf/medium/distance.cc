#include "medium/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "medium/contour_pieces.h"

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

    void mark_tiles(Distance &distance, const Mesh &mesh)
    {
      Tiles &tiles = distance.tiles;
      std::fill(tiles.activity.begin(), tiles.activity.end(), Activity::frozen);
      const auto tile_of = [&](double place, int axis, int size, int count)
      {
        const double node = std::floor((place - mesh.lower[axis]) / mesh.spacing[axis]);
        return std::min(std::max(static_cast<int>(node) / size, 0), count - 1);
      };
      for (const ContourPiece &piece : distance.pieces)
      {
        const int left = tile_of(piece.x - distance.band, 0, Tiles::width, tiles.columns),
                  right = tile_of(piece.x + distance.band, 0, Tiles::width, tiles.columns),
                  low = tile_of(piece.y - distance.band, 1, Tiles::height, tiles.rows),
                  high = tile_of(piece.y + distance.band, 1, Tiles::height, tiles.rows);
        for (int row = low; row <= high; ++row)
          for (int column = left; column <= right; ++column)
            tiles.at(column, row) = Activity::active;
      }
    }

    /// Lets the piece claim all nodes of the tile row that are nearer to it than to earlier ones.
    /// Whole aligned lines of 16 nodes are offered: they never leave a tile, and a line just
    /// written can be read again at once.
    void claim(Distance &distance, const Mesh &mesh, int index, int j0, int j1)
    {
      constexpr int line = 16;
      static_assert(Tiles::width % line == 0, "a line of nodes lies in one tile");
      const ContourPiece &piece = distance.pieces[static_cast<std::size_t>(index)];
      const double h = mesh.spacing[0], ratio = mesh.spacing[1] / h, reach = distance.band / h;
      const double x = (piece.x - mesh.lower[0]) / h,
                   y = (piece.y - mesh.lower[1]) / mesh.spacing[1];
      const int low = std::max(j0, static_cast<int>(std::ceil(y - reach / ratio))),
                high = std::min(j1 - 1, static_cast<int>(std::floor(y + reach / ratio)));
      for (int j = low; j <= high; ++j)
      {
        const double dy = (j - y) * ratio, half = std::sqrt(std::max(0., reach * reach - dy * dy));
        const int i0 = std::max(0, static_cast<int>(std::ceil(x - half))) / line * line,
                  i1 = std::min(mesh.nodes[0] - 1, static_cast<int>(std::floor(x + half)));
        const float dy2 = static_cast<float>(dy * dy);
        for (int i = i0; i <= i1; i += line)
        {
          float *nearest = distance.nearest.row(j) + i;
          int *owner = distance.piece.row(j) + i;
          const float start = static_cast<float>(i - x);
#pragma omp simd
          for (int n = 0; n < line; ++n)
          {
            const float dx = start + static_cast<float>(n), square = dx * dx + dy2;
            const bool nearer = square < nearest[n];
            nearest[n] = nearer ? square : nearest[n];
            owner[n] = nearer ? index : owner[n];
          }
        }
      }
    }

    template <class T>
    void measure_row(Distance &distance, const T *phi, const Mesh &mesh, int j, int i0, int i1)
    {
      const double band = distance.band, h = std::max(mesh.spacing[0], mesh.spacing[1]);
      const double x0 = mesh.lower[0], dx = mesh.spacing[0],
                   y = mesh.lower[1] + j * mesh.spacing[1];
      int *owner = distance.piece.row(j);
      double *psi = distance.psi.row(j);
      float *offset = distance.offset.row(j);
      const double *pieces = &distance.pieces.data()->x;
#pragma omp simd
      for (int i = i0; i < i1; ++i)
      {
        const int at = 5 * (owner[i] < 0 ? 0 : owner[i]);
        const double rx = x0 + i * dx - pieces[at], ry = y - pieces[at + 1];
        const double nx = pieces[at + 2], ny = pieces[at + 3], bend = pieces[at + 4];
        const double m = rx * nx + ry * ny, s = ry * nx - rx * ny, square = rx * rx + ry * ry;
        const double under = 1. - 2. * bend * m + bend * bend * square;
        const double root = std::sqrt(under > 0.0025 ? under : 0.0025), on_circle = s / root;
        const bool fits = (under > 0.0025) & (std::abs(on_circle) <= h);
        const double half = s > 0. ? 0.5 * h : -0.5 * h;
        const double on_segment = std::abs(s) < 0.5 * h ? s : half;
        const double to_circle = std::abs(2. * m - bend * square) / (1. + root);
        const double to_segment = std::sqrt((s - on_segment) * (s - on_segment) + m * m);
        const double size = fits ? to_circle : to_segment;
        const bool inside = (owner[i] >= 0) & (size < band);
        const double kept = inside ? size : band;
        psi[i] = phi[i] > 0 ? kept : -kept;
        owner[i] = inside ? owner[i] : -1;
        offset[i] = static_cast<float>(fits ? on_circle : on_segment);
      }
    }

    /// Pieces that can reach the rows [j0, j1), each of which claims its nodes there.
    void claim_rows(Distance &distance, const Mesh &mesh, int j0, int j1)
    {
      const int reach = static_cast<int>(std::ceil(distance.band / mesh.spacing[1])) + 1;
      const int rows = distance.psi.nodes(1), count = static_cast<int>(distance.pieces.size());
      const auto first = [&](int j) { return distance.first_of_row[static_cast<std::size_t>(j)]; };
      const int begin = j0 - reach <= 0 ? 0 : first(j0 - reach),
                end = j1 + reach >= rows ? count : first(j1 + reach);
      for (int k = begin; k < end; ++k)
        claim(distance, mesh, k, j0, j1);
    }

    template <class T>
    void measure_tile_row(Distance &distance, const Tiles &before, const Field<T> &phi,
                          const Mesh &mesh, int row)
    {
      const Tiles &tiles = distance.tiles;
      const int j0 = tiles.first_row(row), j1 = tiles.end_row(row);
      bool any = false;
      for (int column = 0; column < tiles.columns; ++column)
      {
        const bool now = tiles.at(column, row) == Activity::active;
        any = any || now;
        if (!now && before.at(column, row) != Activity::active)
          continue;
        const int i0 = tiles.first_node(column), i1 = tiles.end_node(column);
        for (int j = j0; j < j1; ++j)
        {
          std::fill(distance.piece.row(j) + i0, distance.piece.row(j) + i1, -1);
          std::fill(distance.nearest.row(j) + i0, distance.nearest.row(j) + i1,
                    std::numeric_limits<float>::max());
        }
      }
      if (any)
        claim_rows(distance, mesh, j0, j1);
      for (int column = 0; column < tiles.columns; ++column)
        if (tiles.at(column, row) == Activity::active || before.at(column, row) == Activity::active)
          for (int j = j0; j < j1; ++j)
            measure_row(distance, phi.row(j), mesh, j, tiles.first_node(column),
                        tiles.end_node(column));
    }
  } // namespace

  Distance::Distance(const Mesh &mesh, double band_cells)
      : band(band_cells * std::max(mesh.spacing[0], mesh.spacing[1])), psi(mesh), piece(mesh, -1),
        offset(mesh), tiles(mesh), nearest(mesh)
  {
    if (!(band_cells >= 3.))
      throw std::invalid_argument("the band of the distance is " + std::to_string(band_cells) +
                                  " cells wide; it must be at least 3, because cells cut by the "
                                  "contour and their neighbours need a distance");
  }

  template <class T>
  void measure(Distance &distance, const Field<T> &phi, const Mesh &mesh)
  {
    distance.pieces = contour_pieces(phi, mesh);
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
#pragma omp parallel for schedule(static)
    for (int row = 0; row < distance.tiles.rows; ++row)
      measure_tile_row(distance, before, phi, mesh, row);
  }

  template void measure(Distance &, const Field<double> &, const Mesh &);
  template void measure(Distance &, const Field<float> &, const Mesh &);

  Point closest_point(const Distance &distance, int i, int j)
  {
    const ContourPiece &piece = distance.pieces[static_cast<std::size_t>(distance.piece(i, j))];
    const double s = distance.offset(i, j), bend = 0.5 * piece.curvature * s * s;
    return {piece.x - s * piece.normal_y + bend * piece.normal_x,
            piece.y + s * piece.normal_x + bend * piece.normal_y};
  }
} // namespace medium
