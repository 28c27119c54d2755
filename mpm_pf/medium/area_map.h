// The solid area of every cell at one moment, and what growth has changed since.
//
// Measured just before and just after growth, the difference is what Eq. (1)'s right side grew or
// melted, and nothing that advection moved or lost. The cost of an update is reading phi once
// (signs of whole chunks of a row); areas are computed only where the contour runs.
#pragma once

#include <cstdint>
#include <vector>

#include "medium/cell_area.h"

namespace medium
{
  /// Cell (i, j) of a mesh has the number j cells_x + i.
  struct CellValue
  {
    long cell;
    double value;
  };
  using CellValues = std::vector<CellValue>; // in the order of the cells

  class AreaMap
  {
  public:
    /// Room for all cells, nothing solid.
    explicit AreaMap(const Mesh &);

    /// The areas now. `active`: the rectangle between moving walls.
    void measure(const Field<double> &phi, const Mesh &, const std::optional<scene::Box> &active);
    /// The same, and what has changed since the last update, length^2. Cells behind a wall are left
    /// out.
    CellValues change(const Field<double> &phi, const Mesh &,
                      const std::optional<scene::Box> &active);

    double at(int i, int j) const { return area[static_cast<std::size_t>(j) * cells[0] + i]; }
    /// Sum of the areas of the cells between the walls of the last update, length^2.
    double total() const;
    std::size_t bytes() const { return area.size() * sizeof(double) + state.size(); }

  private:
    enum State : std::uint8_t
    {
      empty,
      full,
      mixed
    };
    template <typename F>
    void update(const Field<double> &, const Mesh &, const std::optional<scene::Box> &,
                F &&changed);
    template <typename F>
    void set(const CellAreas &, int i, int j, F &&changed);

    std::array<int, 2> cells;
    int chunks;                           // of a row
    std::vector<double> area;             // of each cell
    std::vector<std::uint8_t> state;      // of each chunk
    std::array<int, 4> range{0, 0, 0, 0}; // first and end cell of both axes at the last update
  };

  /// Solid area between the walls, length^2.
  double solid_area(const Field<double> &phi, const Mesh &,
                    const std::optional<scene::Box> &active = std::nullopt);
} // namespace medium
