#include "medium/extension.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "medium/nearest_piece.h"
#include "medium/reinitialisation.h"
#include "record/stopwatch.h"

namespace medium
{
  namespace
  {
    /// What all nodes of one row need to know.
    struct Row
    {
      double *field;
      const double *psi;
      const int *piece, *map;
      const double *offset;
      const unsigned char *material; // null: everywhere
      double y, depth;
      const ContourPiece *pieces;
      const PieceValue *values; // of the pieces
      const double *far_values; // of the pieces of the map
    };

    /// Columns of one tile.
    struct Columns
    {
      int begin, end;
    };

    bool solid(const Row &row, int i)
    {
      return row.psi[i] >= row.depth && (!row.material || row.material[i]);
    }

    /// Nodes in a tile of the band: value at the closest point, or on the line inside the contour.
    void fill_band(const Row &row, Columns columns, const Mesh &mesh)
    {
      double *field = row.field;
      for (int i = columns.begin; i < columns.end; ++i)
      {
        if (solid(row, i))
          continue;
        const int owner = row.piece[i];
        if (owner < 0)
        {
          field[i] = row.far_values[row.map[i]];
          continue;
        }
        const ContourPiece &piece = row.pieces[owner];
        const PieceValue &at = row.values[owner];
        const double s = row.offset[i];
        const bool inside = row.psi[i] > 0.;
        const double x = inside ? mesh.lower[0] + i * mesh.spacing[0] - piece.x
                                : -s * piece.normal_y,
                     y = inside ? row.y - piece.y : s * piece.normal_x;
        field[i] = at.value + at.slope_x * x + at.slope_y * y;
      }
    }

    /// Nodes of a tile beyond the band; it is all liquid or all solid.
    void fill_far(const Row &row, Columns columns)
    {
      const int *map = row.map;
      const double *values = row.far_values;
      double *field = row.field;
      const int i0 = columns.begin, i1 = columns.end;
      if (row.psi[i0] < row.depth)
#pragma omp simd
        for (int i = i0; i < i1; ++i)
          field[i] = values[map[i]];
      else if (row.material)
        for (int i = i0; i < i1; ++i)
          field[i] = row.material[i] ? field[i] : values[map[i]];
    }

    void fill(Field<double> &field, const Extension &extension,
              const std::vector<PieceValue> &values, const PieceFit &how, const Mesh &mesh)
    {
      const Distance &distance = extension.distance;
      const Tiles &tiles = distance.tiles;
#pragma omp parallel for schedule(static)
      for (int tile_row = 0; tile_row < tiles.rows; ++tile_row)
        for (int j = tiles.first_row(tile_row); j < tiles.end_row(tile_row); ++j)
        {
          const Row row{field.row(j),
                        distance.psi.row(j),
                        distance.piece.row(j),
                        extension.nearest_piece.row(j),
                        distance.offset.row(j),
                        how.material.empty() ? nullptr : how.material.row(j),
                        mesh.lower[1] + j * mesh.spacing[1],
                        how.depth,
                        distance.pieces.data(),
                        values.data(),
                        extension.far_value.data()};
          for (int column = 0; column < tiles.columns; ++column)
          {
            const Columns columns{tiles.first_node(column), tiles.end_node(column)};
            if (tiles.at(column, tile_row) == Activity::active)
              fill_band(row, columns, mesh);
            else
              fill_far(row, columns);
          }
        }
    }

    void build_map(Extension &extension, const Mesh &mesh)
    {
      find_nearest_piece(extension.nearest_piece, extension.distance, mesh);
      extension.mapped_pieces.clear();
      for (const ContourPiece &piece : extension.distance.pieces)
        extension.mapped_pieces.emplace_back(piece.x, piece.y);
    }

    /// Today's number of the piece that is nearest to where each piece of the map was.
    std::vector<int> renumber(const Extension &extension, const Mesh &mesh)
    {
      std::vector<int> now;
      now.reserve(extension.mapped_pieces.size());
      for (const Point &place : extension.mapped_pieces)
      {
        const Point node = (place - mesh.lower).cwiseQuotient(mesh.spacing);
        const int i = std::clamp(static_cast<int>(std::lround(node[0])), 0, mesh.nodes[0] - 1),
                  j = std::clamp(static_cast<int>(std::lround(node[1])), 0, mesh.nodes[1] - 1);
        const int owner = extension.distance.piece(i, j);
        // A piece that is gone (melted, closed over) leaves its part of the map to the one before.
        now.push_back(owner >= 0 ? owner : now.empty() ? 0 : now.back());
      }
      return now;
    }

    /// From the values at the pieces, which are returned, to all nodes outside the solid.
    std::vector<std::vector<PieceValue>> write(Extension &extension,
                                               const std::vector<Field<double> *> &fields,
                                               const PieceFit &how, const Mesh &mesh)
    {
      const std::vector<int> now = renumber(extension, mesh);
      auto values = piece_values(extension.distance, fields, how, mesh);
      for (std::size_t f = 0; f < fields.size(); ++f)
      {
        extension.far_value.resize(now.size());
        for (std::size_t k = 0; k < now.size(); ++k)
          extension.far_value[k] = values[f][static_cast<std::size_t>(now[k])].value;
        fill(*fields[f], extension, values[f], how, mesh);
        if (extension.method == scene::ExtensionMethod::pde)
          march_extension(*fields[f], extension.distance, how.material, how.depth, mesh);
      }
      return values;
    }
  } // namespace

  Extension::Extension(const Mesh &mesh, const scene::Extension &settings, double front_width)
      : method(settings.method), front_width(front_width),
        depth(0.5 * std::max(mesh.spacing[0], mesh.spacing[1])), interval(settings.interval),
        map_interval(settings.map_interval), distance(mesh, settings.band), nearest_piece(mesh)
  {
  }

  namespace
  {
    template <class T>
    void measure_distance(Extension &extension, const Field<T> &phi, const Mesh &mesh,
                          const bool afresh)
    {
      const record::PartTimer timer(extension.measuring);
      Distance &distance = extension.distance;
      afresh ? compute_distance(distance, phi, mesh) : update_distance(distance, phi, mesh);
      if (extension.method == scene::ExtensionMethod::pde)
        reinitialise(distance, phi, extension.front_width, mesh);
      extension.since_measured = 0;
    }

    /// phi between the nodes, at a place inside the mesh.
    template <class T>
    double interpolated(const Field<T> &phi, const double x, const double y, const Mesh &mesh)
    {
      const double u = (x - mesh.lower[0]) / mesh.spacing[0],
                   v = (y - mesh.lower[1]) / mesh.spacing[1];
      const int i = std::clamp(static_cast<int>(std::floor(u)), 0, mesh.nodes[0] - 2),
                j = std::clamp(static_cast<int>(std::floor(v)), 0, mesh.nodes[1] - 2);
      const double s = u - i, t = v - j;
      return (1. - t) * ((1. - s) * phi(i, j) + s * phi(i + 1, j)) +
             t * ((1. - s) * phi(i, j + 1) + s * phi(i + 1, j + 1));
    }

    /// Has the contour gone on by more than a cell anywhere since its pieces were found? What phi
    /// is at a piece's place now tells by how much, phi = tanh(distance/(sqrt(2) W)); where it is
    /// 1 or -1 to a thousandth, and so says only that it is far, it has.
    template <class T>
    bool has_moved_on(const Extension &extension, const Field<T> &phi, const Mesh &mesh)
    {
      constexpr double full = 0.999;
      const double cell = mesh.spacing.maxCoeff(), far = std::sqrt(2.) * extension.front_width;
      const double most = std::min(full, std::tanh(cell / far));
      const auto &pieces = extension.distance.pieces;
      const Point upper = mesh.position(mesh.nodes[0] - 1, mesh.nodes[1] - 1);
      const auto within = [&](const ContourPiece &piece) // no image beyond a periodic side
      {
        return piece.x >= mesh.lower[0] && piece.x <= upper[0] && piece.y >= mesh.lower[1] &&
               piece.y <= upper[1];
      };
      return std::any_of(pieces.begin(), pieces.end(),
                         [&](const ContourPiece &piece) {
                           return within(piece) &&
                                  std::abs(interpolated(phi, piece.x, piece.y, mesh)) > most;
                         });
    }
  } // namespace

  template <class T>
  void extend_into_liquid(Extension &extension, const std::vector<Field<double> *> &fields,
                          const Field<T> &phi, const Field<unsigned char> &material,
                          const Mesh &mesh)
  {
    const bool rebuild = extension.calls++ % extension.map_interval == 0;
    if (rebuild || ++extension.since_measured >= extension.interval ||
        has_moved_on(extension, phi, mesh))
      measure_distance(extension, phi, mesh, rebuild);
    if (rebuild)
      build_map(extension, mesh);
    extension.at_pieces =
        write(extension, fields, {material, extension.depth, Approach::linear}, mesh);
  }

  void fit_at_pieces(Extension &extension, const std::vector<Field<double> *> &fields,
                     const Field<unsigned char> &material, const Mesh &mesh)
  {
    extension.at_pieces = piece_values(extension.distance, fields,
                                       {material, extension.depth, Approach::linear}, mesh);
  }

  void extend_inherited(Extension &extension, const std::vector<Field<double> *> &fields,
                        const Mesh &mesh)
  {
    if (extension.distance.pieces.empty() || extension.mapped_pieces.empty())
      throw std::logic_error("extend_inherited was called before extend_into_liquid");
    write(extension, fields, {Field<unsigned char>{}, 0., Approach::level}, mesh);
  }

  template void extend_into_liquid(Extension &, const std::vector<Field<double> *> &,
                                   const Field<double> &, const Field<unsigned char> &,
                                   const Mesh &);
  template void extend_into_liquid(Extension &, const std::vector<Field<double> *> &,
                                   const Field<float> &, const Field<unsigned char> &,
                                   const Mesh &);
} // namespace medium
