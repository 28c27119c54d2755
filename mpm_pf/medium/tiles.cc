#include "medium/tiles.h"

#include <algorithm>

namespace medium
{
  Tiles::Tiles(const Mesh &mesh)
      : columns((mesh.nodes[0] + width - 1) / width), rows((mesh.nodes[1] + height - 1) / height),
        nodes(mesh.nodes),
        activity(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                 Activity::active)
  {
  }

  long Tiles::count(Activity wanted) const
  {
    return std::count(activity.begin(), activity.end(), wanted);
  }

  template <class Real>
  TileState<Real> classify_tile(const Tiles &tiles, int column, int row, const Field<Real> *phi,
                                const Field<Real> *theta, Real flatness, bool &finite)
  {
    const int begin = tiles.first_node(column), end = tiles.end_node(column);
    TileState<Real> state;
    state.well = -1;
    state.constant = true;
    if (phi)
    {
      Real least = phi->row(tiles.first_row(row))[begin], most = least;
      int good = 1; // a comparison with NaN is false, so NaN cannot hide behind min and max
      for (int j = tiles.first_row(row); j < tiles.end_row(row); ++j)
      {
        const Real *f = phi->row(j);
#pragma omp simd reduction(min : least) reduction(max : most) reduction(& : good)
        for (int i = begin; i < end; ++i)
        {
          least = f[i] < least ? f[i] : least;
          most = f[i] > most ? f[i] : most;
          good &= static_cast<int>(f[i] * f[i] < Real(4));
        }
      }
      finite = finite && good;
      const bool solid = least >= 1 - flatness && most <= 1 + flatness;
      const bool liquid = least >= -1 - flatness && most <= -1 + flatness;
      state.well = static_cast<std::int8_t>(solid ? 1 : (liquid ? -1 : 0));
    }
    if (theta)
    {
      state.value = theta->row(tiles.first_row(row))[begin];
      int same = 1;
      for (int j = tiles.first_row(row); j < tiles.end_row(row); ++j)
      {
        const Real *f = theta->row(j);
        const Real value = state.value;
#pragma omp simd reduction(& : same)
        for (int i = begin; i < end; ++i)
          same &= static_cast<int>(f[i] == value);
      }
      state.constant = same;
    }
    return state;
  }

  template TileState<double> classify_tile(const Tiles &, int, int, const Field<double> *,
                                           const Field<double> *, double, bool &);
  template TileState<float> classify_tile(const Tiles &, int, int, const Field<float> *,
                                          const Field<float> *, float, bool &);

  namespace
  {
    /// Neighbouring tile index along one axis; a periodic axis closes on itself.
    int neighbour(int index, int count, bool periodic)
    {
      if (periodic)
        return (index + 2 * count) % count;
      return std::clamp(index, 0, count - 1);
    }

    template <class Real>
    void update_all(Tiles &tiles, const Mesh &mesh, const std::vector<TileState<Real>> &states)
    {
      const bool wrap_x = mesh.side(Edge::left) == Boundary::periodic;
      const bool wrap_y = mesh.side(Edge::bottom) == Boundary::periodic;
      // Across a periodic side the neighbour may be the narrow rest of a row of tiles.
      const int reach_x = wrap_x ? 2 : 1, reach_y = wrap_y ? 2 : 1;
      for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column)
        {
          const TileState<Real> &centre = states[tiles.index(column, row)];
          bool same_well = centre.well != 0, same_heat = centre.constant;
          for (int b = -reach_y; b <= reach_y; ++b)
            for (int a = -reach_x; a <= reach_x; ++a)
            {
              const TileState<Real> &other =
                  states[tiles.index(neighbour(column + a, tiles.columns, wrap_x),
                                     neighbour(row + b, tiles.rows, wrap_y))];
              same_well = same_well && other.well == centre.well;
              same_heat = same_heat && other.constant && other.value == centre.value;
            }
          tiles.at(column, row) = !same_well   ? Activity::active
                                  : !same_heat ? Activity::heat_only
                                               : Activity::frozen;
        }
    }
  } // namespace

  void update_activity(Tiles &tiles, const Mesh &mesh, const std::vector<TileState<double>> &states)
  {
    update_all(tiles, mesh, states);
  }
  void update_activity(Tiles &tiles, const Mesh &mesh, const std::vector<TileState<float>> &states)
  {
    update_all(tiles, mesh, states);
  }
} // namespace medium
