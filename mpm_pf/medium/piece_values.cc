#include "medium/piece_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medium
{
  namespace
  {
    constexpr int reach = 2; // nodes each way round the middle of a stencil
    constexpr int stencil = (2 * reach + 1) * (2 * reach + 1);

    /// Solid nodes round one piece: where, how heavy, how far (units of the spacing).
    struct Around
    {
      int count = 0;
      std::array<std::ptrdiff_t, stencil> node; // offset from row 0
      std::array<double, stencil> weight, x, y;
      double sum = 0., mean_x = 0., mean_y = 0.;
      double inverse_xx = 0., inverse_xy = 0., inverse_yy = 0.; // of the centred moments
    };

    Around look_around(const ContourPiece &piece, const Distance &distance, const PieceFit &how,
                       const Mesh &mesh)
    {
      Around around;
      const double hx = mesh.spacing[0], hy = mesh.spacing[1];
      const double x = (piece.x - mesh.lower[0]) / hx, y = (piece.y - mesh.lower[1]) / hy;
      // The stencil sits inside the solid, where its nodes are.
      const int middle_x = static_cast<int>(std::lround(x + 1.5 * piece.normal_x)),
                middle_y = static_cast<int>(std::lround(y + 1.5 * piece.normal_y));
      for (int j = std::max(middle_y - reach, 0);
           j <= std::min(middle_y + reach, mesh.nodes[1] - 1); ++j)
        for (int i = std::max(middle_x - reach, 0);
             i <= std::min(middle_x + reach, mesh.nodes[0] - 1); ++i)
        {
          const double dx = i - x, dy = j - y, left = 1. - (dx * dx + dy * dy) / 12.;
          if (left <= 0. || distance.psi(i, j) < how.depth ||
              (!how.material.empty() && !how.material(i, j)))
            continue;
          const auto n = static_cast<std::size_t>(around.count++);
          around.node[n] = j * distance.psi.pitch() + i;
          around.weight[n] = left * left, around.x[n] = dx, around.y[n] = dy;
          around.sum += left * left;
          around.mean_x += left * left * dx, around.mean_y += left * left * dy;
        }
      return around;
    }

    /// The inverse of the centred moments, where the nodes span the plane: the gradient is this
    /// times the first moments of the field. Level: of the moments along the contour only.
    void solve_moments(Around &around, const ContourPiece &piece, Approach approach)
    {
      around.mean_x /= around.sum, around.mean_y /= around.sum;
      double xx = 0., xy = 0., yy = 0.;
      for (std::size_t n = 0; n < static_cast<std::size_t>(around.count); ++n)
      {
        const double dx = around.x[n] - around.mean_x, dy = around.y[n] - around.mean_y;
        xx += around.weight[n] * dx * dx, xy += around.weight[n] * dx * dy;
        yy += around.weight[n] * dy * dy;
      }
      if (approach == Approach::level)
      {
        const double x = -piece.normal_y, y = piece.normal_x;
        const double along = x * x * xx + 2. * x * y * xy + y * y * yy;
        const double inverse = along > 0.05 * around.sum ? 1. / along : 0.;
        around.inverse_xx = inverse * x * x, around.inverse_xy = inverse * x * y;
        around.inverse_yy = inverse * y * y;
        return;
      }
      // Spread of the nodes along their thinnest direction: 0.05 of a cell squared, say one row of
      // nodes with a single one beside it, is too little to tell a gradient.
      const double determinant = xx * yy - xy * xy, trace = xx + yy;
      if (!(determinant > 0.05 * around.sum * trace)) // a single node has neither
        return;
      around.inverse_xx = yy / determinant, around.inverse_yy = xx / determinant;
      around.inverse_xy = -xy / determinant;
    }

    PieceValue fit(const Around &around, const double *field, const Mesh &mesh)
    {
      double mean = 0., along_x = 0., along_y = 0.;
      for (std::size_t n = 0; n < static_cast<std::size_t>(around.count); ++n)
        mean += around.weight[n] * field[around.node[n]];
      mean /= around.sum;
      for (std::size_t n = 0; n < static_cast<std::size_t>(around.count); ++n)
      {
        const double here = around.weight[n] * (field[around.node[n]] - mean);
        along_x += here * (around.x[n] - around.mean_x);
        along_y += here * (around.y[n] - around.mean_y);
      }
      const double slope_x = around.inverse_xx * along_x + around.inverse_xy * along_y,
                   slope_y = around.inverse_xy * along_x + around.inverse_yy * along_y;
      return {mean - slope_x * around.mean_x - slope_y * around.mean_y, slope_x / mesh.spacing[0],
              slope_y / mesh.spacing[1]};
    }

    /// Pieces that know nothing ask the nearest one that does.
    void fill_unknown(std::vector<std::vector<PieceValue>> &values,
                      const std::vector<unsigned char> &known, const Distance &distance)
    {
      std::vector<std::size_t> sources;
      for (std::size_t k = 0; k < known.size(); ++k)
        if (known[k])
          sources.push_back(k);
      if (sources.empty())
        return;
      for (std::size_t k = 0; k < known.size(); ++k)
      {
        if (known[k])
          continue;
        double least = std::numeric_limits<double>::max();
        std::size_t nearest = sources.front();
        for (const std::size_t source : sources)
        {
          const double dx = distance.pieces[source].x - distance.pieces[k].x,
                       dy = distance.pieces[source].y - distance.pieces[k].y;
          if (dx * dx + dy * dy < least)
            least = dx * dx + dy * dy, nearest = source;
        }
        for (auto &field : values)
          field[k] = {field[nearest].value, 0., 0.};
      }
    }
  } // namespace

  std::vector<std::vector<PieceValue>> piece_values(const Distance &distance,
                                                    const std::vector<Field<double> *> &fields,
                                                    const PieceFit &how, const Mesh &mesh)
  {
    const std::size_t count = distance.pieces.size();
    std::vector<std::vector<PieceValue>> values(fields.size(), std::vector<PieceValue>(count));
    std::vector<unsigned char> known(count, 0);
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < count; ++k)
    {
      Around around = look_around(distance.pieces[k], distance, how, mesh);
      known[k] = around.count > 0;
      if (!known[k])
        continue;
      solve_moments(around, distance.pieces[k], how.approach);
      for (std::size_t f = 0; f < fields.size(); ++f)
        values[f][k] = fit(around, fields[f]->row(0), mesh);
    }
    fill_unknown(values, known, distance);
    return values;
  }
} // namespace medium
