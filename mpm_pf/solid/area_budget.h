// What a growing solid remembers between steps: areas before growth, areas owed to the points.
#pragma once

#include "medium/area_map.h"
#include "solid/body.h"
#include "solid/growing.h"

namespace solid
{
  /// An owed area above this part of a cell becomes a point.
  inline constexpr double least_share = 0.25;

  struct Growing
  {
    explicit Growing(const scene::Domain &domain) : map(medium::make_mesh(domain)) {}

    medium::AreaMap map;
    medium::CellValues owed; // length^2; negative: owed by the points
    AreaBudget budget;       // without points and owed
  };

  /// For a checkpoint, and back.
  std::vector<double> pack_growth(const Solid &);
  void unpack_growth(Solid &, const std::vector<double> &);

  /// Sum of two sorted lists; cells that owe nothing are dropped.
  medium::CellValues merged(const medium::CellValues &, const medium::CellValues &);

  /// Debts of cells that the contour does not cross go to the nearest that it does, within three
  /// cells, in equal shares to several that are equally near; where there is none, debts gather in
  /// one cell for each eight cells.
  void transfer_owed_area(medium::CellValues &owed, const medium::CellAreas &,
                          const std::array<int, 2> &cells);

  /// Take points from cells that owe a negative area, outermost (lowest phi) first, as long as that
  /// brings the debt nearer to zero.
  void remove_melted_points(Solid &, const medium::CellAreas &);

  /// Add a free point; its index. The grid must be sorted again afterwards.
  std::size_t insert_point(Solid &, const Point &position, double mass);
  /// Remove free points, given in ascending order.
  void erase_points(Solid &, const std::vector<std::size_t> &);
} // namespace solid
