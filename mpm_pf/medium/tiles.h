// Tiles of the mesh, so that work is done only where something happens.
//
// A tile is 32 x 8 nodes. Each is in one of three states: active (Eqs. (1) and (2)), heat_only
// (Eq. (2); phi sits at one of its two wells) or frozen (nothing can change). A tile is classified
// by itself *and its eight neighbours*: skipping nodes just because they are flat themselves would
// freeze the front at its own tail.
#pragma once

#include <cstdint>
#include <vector>

#include "medium/field.h"

namespace medium
{
  enum class Activity : std::int8_t
  {
    frozen,
    heat_only,
    active
  };

  struct Tiles
  {
    static constexpr int width = 32, height = 8;

    Tiles() = default;
    explicit Tiles(const Mesh &);

    int columns = 0, rows = 0;
    std::array<int, 2> nodes{0, 0};
    std::vector<Activity> activity; // columns x rows, column fastest

    Activity &at(int column, int row) { return activity[index(column, row)]; }
    Activity at(int column, int row) const { return activity[index(column, row)]; }
    std::size_t index(int column, int row) const
    {
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(column);
    }
    int first_node(int column) const { return column * width; }
    int end_node(int column) const { return std::min((column + 1) * width, nodes[0]); }
    int first_row(int row) const { return row * height; }
    int end_row(int row) const { return std::min((row + 1) * height, nodes[1]); }
    long count(Activity) const;
  };

  /// What one tile looks like by itself.
  template <class Real>
  struct TileState
  {
    std::int8_t well = 0;  // +1 or -1: phi is there within the flatness; 0: neither
    bool constant = false; // theta has one and the same value at all nodes, to the last bit
    Real value = 0;        // that value
  };

  /// Classifies the nodes of one tile. `theta` may be null: then it counts as constant.
  /// Returns false in `finite` if |phi| exceeds 2 or is not a number.
  template <class Real>
  TileState<Real> classify_tile(const Tiles &, int column, int row, const Field<Real> *phi,
                                const Field<Real> *theta, Real flatness, bool &finite);

  /// Activity of every tile from all states: active unless the 3 x 3 tiles round it sit in the same
  /// well, frozen if moreover theta is one constant on all nine. Periodic sides are followed.
  void update_activity(Tiles &, const Mesh &, const std::vector<TileState<double>> &);
  void update_activity(Tiles &, const Mesh &, const std::vector<TileState<float>> &);
} // namespace medium
