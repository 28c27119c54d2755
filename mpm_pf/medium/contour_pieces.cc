#include "medium/contour_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "medium/crossing.h"

namespace medium
{
  namespace
  {
    /// The piece where phi crosses zero between `node` and the next node `along`; `across` leads to
    /// the next line. The spacings go with them.
    template <class T>
    ContourPiece piece_on_line(const T *node, std::ptrdiff_t along, std::ptrdiff_t across,
                               double spacing_along, double spacing_across, double &fraction)
    {
      double value[4], slope[4], bend[4];
      for (int k = 0; k < 4; ++k)
      {
        double f[5];
        for (int l = 0; l < 5; ++l)
          f[l] = straightened(static_cast<double>(node[(k - 1) * along + (l - 2) * across]));
        value[k] = f[2];
        slope[k] = (f[0] - 8. * f[1] + 8. * f[3] - f[4]) / 12.;
        bend[k] = (-f[0] + 16. * f[1] - 30. * f[2] + 16. * f[3] - f[4]) / 12.;
      }
      const Cubic f(value), g(slope), b(bend);
      const double s = fraction = root_between(f);
      const double fa = f.slope(s) / spacing_along, fc = g.value(s) / spacing_across;
      const double faa = f.bend(s) / (spacing_along * spacing_along),
                   fac = g.slope(s) / (spacing_along * spacing_across),
                   fcc = b.value(s) / (spacing_across * spacing_across);
      const double size = std::hypot(fa, fc);
      // Where the cubic is level at its root the chord still knows the way into the solid.
      const bool level = !(size > 1e-3 * std::abs(value[2] - value[1]) / spacing_along);
      ContourPiece piece{};
      piece.normal_x = level ? (value[2] > value[1] ? 1. : -1.) : fa / size;
      piece.normal_y = level ? 0. : fc / size;
      const double limit = 1. / std::max(spacing_along, spacing_across);
      const double curvature =
          level ? 0. : -(faa * fc * fc - 2. * fac * fa * fc + fcc * fa * fa) / (size * size * size);
      piece.curvature = std::min(std::max(curvature, -limit), limit);
      return piece;
    }

    template <class T>
    void pieces_of_row(const Field<T> &phi, const Mesh &mesh, int j,
                       std::vector<ContourPiece> &pieces)
    {
      const T *row = phi.row(j), *above = phi.row(j + 1);
      const int nx = mesh.nodes[0], last_row = mesh.nodes[1] - 1;
      const std::ptrdiff_t pitch = phi.pitch();
      constexpr int chunk = 64;
      for (int i0 = 0; i0 < nx; i0 += chunk)
      {
        const int i1 = std::min(i0 + chunk, nx);
        int changes = 0;
        for (int i = i0; i < i1; ++i)
          changes += ((row[i] > 0) != (row[i + 1] > 0)) + ((row[i] > 0) != (above[i] > 0));
        if (changes == 0)
          continue;
        for (int i = i0; i < i1; ++i)
        {
          const double x = mesh.lower[0] + i * mesh.spacing[0],
                       y = mesh.lower[1] + j * mesh.spacing[1];
          double s = 0.;
          if (i + 1 < nx && (row[i] > 0) != (row[i + 1] > 0))
          {
            ContourPiece piece =
                piece_on_line(row + i, 1, pitch, mesh.spacing[0], mesh.spacing[1], s);
            piece.x = x + s * mesh.spacing[0], piece.y = y;
            pieces.push_back(piece);
          }
          if (j < last_row && (row[i] > 0) != (above[i] > 0))
          {
            ContourPiece piece =
                piece_on_line(row + i, pitch, 1, mesh.spacing[1], mesh.spacing[0], s);
            std::swap(piece.normal_x, piece.normal_y);
            piece.x = x, piece.y = y + s * mesh.spacing[1];
            pieces.push_back(piece);
          }
        }
      }
    }
  } // namespace

  template <class T>
  std::vector<ContourPiece> contour_pieces(const Field<T> &phi, const Mesh &mesh)
  {
    constexpr int rows_of_chunk = 32; // fixed, so that the order does not depend on the threads
    const int chunks = (mesh.nodes[1] + rows_of_chunk - 1) / rows_of_chunk;
    std::vector<std::vector<ContourPiece>> found(static_cast<std::size_t>(chunks));
#pragma omp parallel for schedule(dynamic)
    for (int chunk = 0; chunk < chunks; ++chunk)
      for (int j = chunk * rows_of_chunk; j < std::min((chunk + 1) * rows_of_chunk, mesh.nodes[1]);
           ++j)
        pieces_of_row(phi, mesh, j, found[static_cast<std::size_t>(chunk)]);
    std::vector<ContourPiece> pieces;
    for (const auto &part : found)
      pieces.insert(pieces.end(), part.begin(), part.end());
    return pieces;
  }

  template std::vector<ContourPiece> contour_pieces(const Field<double> &, const Mesh &);
  template std::vector<ContourPiece> contour_pieces(const Field<float> &, const Mesh &);
} // namespace medium
