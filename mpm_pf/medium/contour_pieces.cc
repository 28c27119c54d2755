#include "medium/contour_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "medium/crossing.h"

namespace medium
{
  namespace
  {
    /// phi crosses zero between node (i, j) and the next one to the right or above.
    struct Crossing
    {
      int i, j;
      bool upward;
    };

    /// Crossings are worked on side by side, as many as two vectors hold.
    constexpr int lanes = 16;

    /// A cubic along the mesh line for each lane (crossing.h), by its coefficients.
    struct Cubics
    {
      alignas(64) double c0[lanes], c1[lanes], c2[lanes], c3[lanes];
      void set(int l, double f0, double f1, double f2, double f3)
      {
        const double f[4] = {f0, f1, f2, f3};
        const Cubic cubic(f);
        c0[l] = cubic.c0, c1[l] = cubic.c1, c2[l] = cubic.c2, c3[l] = cubic.c3;
      }
      double value(int l, double s) const { return c0[l] + s * (c1[l] + s * (c2[l] + s * c3[l])); }
      double slope(int l, double s) const { return c1[l] + s * (2. * c2[l] + s * 3. * c3[l]); }
      double second_derivative(int l, double s) const { return 2. * c2[l] + 6. * c3[l] * s; }
    };

    struct Batch
    {
      alignas(64) double node[4][5][lanes];   // straightened profile: along the line, across it
      Cubics value, slope, second_derivative; // of the profile; of its derivatives across the line
      alignas(64) double along[lanes], across[lanes]; // spacings
      alignas(64) double place[lanes];                // of the crossing between the two nodes
      alignas(64) double normal_along[lanes], normal_across[lanes], curvature[lanes];
    };

    template <class T>
    void load(Batch &batch, const Field<T> &phi, const Mesh &mesh, const Crossing *crossings,
              int count)
    {
      for (int l = 0; l < lanes; ++l)
      {
        const Crossing &at = crossings[std::min(l, count - 1)];
        const std::ptrdiff_t along = at.upward ? phi.pitch() : 1,
                             across = at.upward ? 1 : phi.pitch();
        const T *node = &phi(at.i, at.j) - along - 2 * across;
        for (int k = 0; k < 4; ++k)
          for (int m = 0; m < 5; ++m)
            batch.node[k][m][l] = static_cast<double>(node[k * along + m * across]);
        batch.along[l] = mesh.spacing[at.upward ? 1 : 0];
        batch.across[l] = mesh.spacing[at.upward ? 0 : 1];
      }
    }

    /// The cubics of value and of first and second derivatives across (five nodes, fourth order).
    void prepare(Batch &batch)
    {
      double *all = &batch.node[0][0][0];
#pragma omp simd
      for (int n = 0; n < 4 * 5 * lanes; ++n)
        all[n] = straightened(all[n]);
#pragma omp simd
      for (int l = 0; l < lanes; ++l)
      {
        double slope[4], second_derivative[4];
        for (int k = 0; k < 4; ++k)
        {
          const auto &f = batch.node[k];
          slope[k] = (f[0][l] - 8. * f[1][l] + 8. * f[3][l] - f[4][l]) / 12.;
          second_derivative[k] =
              (-f[0][l] + 16. * f[1][l] - 30. * f[2][l] + 16. * f[3][l] - f[4][l]) / 12.;
        }
        batch.value.set(l, batch.node[0][2][l], batch.node[1][2][l], batch.node[2][2][l],
                        batch.node[3][2][l]);
        batch.slope.set(l, slope[0], slope[1], slope[2], slope[3]);
        batch.second_derivative.set(l, second_derivative[0], second_derivative[1],
                                    second_derivative[2], second_derivative[3]);
      }
    }

    /// Roots of the cubics of value as root_between() of crossing.h finds them, all lanes at once.
    void find_roots(Batch &batch)
    {
      alignas(64) double low[lanes], high[lanes];
      double *place = batch.place;
      for (int l = 0; l < lanes; ++l)
      {
        const double start = batch.value.c0[l];
        low[l] = 0., high[l] = 1., place[l] = start / (start - batch.value.value(l, 1.));
      }
      int open = lanes;
      for (int step = 0; step < 40 && open > 0; ++step)
      {
        open = 0;
#pragma omp simd reduction(+ : open)
        for (int l = 0; l < lanes; ++l)
        {
          const double s = place[l], value = batch.value.value(l, s),
                       slope = batch.value.slope(l, s);
          const bool done = std::abs(value) <= 1e-13 * std::abs(slope);
          const bool before = (value < 0.) == (batch.value.c0[l] < 0.);
          low[l] = before ? s : low[l], high[l] = before ? high[l] : s;
          const double next = s - value / (slope != 0. ? slope : 1.);
          const bool kept = (next > low[l]) & (next < high[l]) & (slope != 0.);
          place[l] = done ? s : kept ? next : 0.5 * (low[l] + high[l]);
          open += done ? 0 : 1;
        }
      }
    }

    void find_normals_and_curvatures(Batch &batch)
    {
#pragma omp simd
      for (int l = 0; l < lanes; ++l)
      {
        const double s = batch.place[l], along = batch.along[l], across = batch.across[l];
        const double fa = batch.value.slope(l, s) / along, fc = batch.slope.value(l, s) / across;
        const double faa = batch.value.second_derivative(l, s) / (along * along),
                     fac = batch.slope.slope(l, s) / (along * across),
                     fcc = batch.second_derivative.value(l, s) / (across * across);
        const double size = std::sqrt(fa * fa + fc * fc);
        // Where the cubic is level at its root the chord still knows the way into the solid.
        const double chord = batch.node[2][2][l] - batch.node[1][2][l];
        const bool level = !(size > 1e-3 * std::abs(chord) / along);
        const double inverse = 1. / (level ? 1. : size);
        batch.normal_along[l] = level ? (chord > 0. ? 1. : -1.) : fa * inverse;
        batch.normal_across[l] = level ? 0. : fc * inverse;
        const double limit = 1. / (along > across ? along : across);
        const double second_derivative =
            -(faa * fc * fc - 2. * fac * fa * fc + fcc * fa * fa) * inverse * inverse * inverse;
        const double kept = second_derivative > limit    ? limit
                            : second_derivative < -limit ? -limit
                                                         : second_derivative;
        batch.curvature[l] = level ? 0. : kept;
      }
    }

    template <class T>
    void append_pieces(std::vector<ContourPiece> &pieces, const std::vector<Crossing> &crossings,
                       const Field<T> &phi, const Mesh &mesh)
    {
      Batch batch;
      for (std::size_t first = 0; first < crossings.size(); first += lanes)
      {
        const int count = static_cast<int>(std::min<std::size_t>(lanes, crossings.size() - first));
        load(batch, phi, mesh, &crossings[first], count);
        prepare(batch);
        find_roots(batch);
        find_normals_and_curvatures(batch);
        for (int l = 0; l < count; ++l)
        {
          const Crossing &at = crossings[first + static_cast<std::size_t>(l)];
          ContourPiece piece{mesh.lower[0] + at.i * mesh.spacing[0],
                             mesh.lower[1] + at.j * mesh.spacing[1], batch.normal_along[l],
                             batch.normal_across[l], batch.curvature[l]};
          (at.upward ? piece.y : piece.x) += batch.place[l] * batch.along[l];
          if (at.upward)
            std::swap(piece.normal_x, piece.normal_y);
          pieces.push_back(piece);
        }
      }
    }

    /// Nodes [i0, i1) of row j, all in one tile.
    struct TileRow
    {
      int j, i0, i1;
    };

    /// Sign changes that start at the nodes of a row: bit 0 to the right, bit 1 upward, a byte a
    /// node, so that eight nodes without any are passed at once.
    template <class T>
    void look_along(std::vector<Crossing> &crossings, const Field<T> &phi, const Mesh &mesh,
                    const TileRow nodes)
    {
      const auto [j, i0, i1] = nodes;
      constexpr int word = sizeof(std::uint64_t);
      const T *row = phi.row(j) + i0, *above = phi.row(j + 1) + i0;
      std::array<unsigned char, Tiles::width> changes{};
#pragma omp simd
      for (int n = 0; n < i1 - i0; ++n)
        changes[static_cast<std::size_t>(n)] = static_cast<unsigned char>(
            ((row[n] > 0) != (row[n + 1] > 0)) | (((row[n] > 0) != (above[n] > 0)) << 1));
      for (int first = 0; first < i1 - i0; first += word)
      {
        std::uint64_t any;
        std::memcpy(&any, changes.data() + first, sizeof any);
        if (any == 0)
          continue;
        for (int n = first; n < first + word; ++n)
        {
          const unsigned char here = changes[static_cast<std::size_t>(n)];
          if ((here & 1) && i0 + n + 1 < mesh.nodes[0])
            crossings.push_back({i0 + n, j, false});
          if ((here & 2) && j + 1 < mesh.nodes[1])
            crossings.push_back({i0 + n, j, true});
        }
      }
    }

    template <class T>
    std::vector<Crossing> crossings_of(const Field<T> &phi, const Mesh &mesh, const Tiles &where,
                                       int tile_row)
    {
      std::vector<Crossing> crossings;
      crossings.reserve(64);
      for (int j = where.first_row(tile_row); j < where.end_row(tile_row); ++j)
        for (int column = 0; column < where.columns; ++column)
          if (where.at(column, tile_row) == Activity::active)
            look_along(crossings, phi, mesh, {j, where.first_node(column), where.end_node(column)});
      return crossings;
    }
  } // namespace

  template <class T>
  std::vector<ContourPiece> contour_pieces(const Field<T> &phi, const Mesh &mesh,
                                           const Tiles &where)
  {
    // Tile rows are joined in their order, so that the result does not depend on the threads.
    std::vector<std::vector<ContourPiece>> found(static_cast<std::size_t>(where.rows));
#pragma omp parallel for schedule(dynamic, 4)
    for (int row = 0; row < where.rows; ++row)
      append_pieces(found[static_cast<std::size_t>(row)], crossings_of(phi, mesh, where, row), phi,
                    mesh);
    std::vector<ContourPiece> pieces;
    for (const auto &part : found)
      pieces.insert(pieces.end(), part.begin(), part.end());
    return pieces;
  }

  template std::vector<ContourPiece> contour_pieces(const Field<double> &, const Mesh &,
                                                    const Tiles &);
  template std::vector<ContourPiece> contour_pieces(const Field<float> &, const Mesh &,
                                                    const Tiles &);
} // namespace medium
