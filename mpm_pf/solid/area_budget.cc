#include "solid/area_budget.h"

#include <algorithm>
#include <cmath>

#include "solid/energy.h"

namespace solid
{
  namespace
  {
    struct Cells
    {
      const medium::CellAreas &areas;
      std::array<int, 2> count;

      // A cell behind a wall stands for the one in front of it.
      std::array<int, 2> indices(const long cell) const
      {
        std::array<int, 2> at{static_cast<int>(cell % count[0]), static_cast<int>(cell / count[0])};
        for (int k = 0; k < 2; ++k)
          at[k] = std::min(std::max(at[k], areas.first_cell(k)), areas.end_cell(k) - 1);
        return at;
      }
      bool exists(const int i, const int j) const
      {
        return i >= areas.first_cell(0) && i < areas.end_cell(0) && j >= areas.first_cell(1) &&
               j < areas.end_cell(1);
      }
      long number(const int i, const int j) const { return static_cast<long>(j) * count[0] + i; }
    };

    // The cells nearest to `from` that the contour crosses; several where they are equally near.
    std::vector<long> nearest_interfaces(const Cells &cells, const std::array<int, 2> &from)
    {
      constexpr int reach = 3;
      std::vector<long> found;
      int least = 2 * reach * reach;
      for (int dj = -reach; dj <= reach; ++dj)
        for (int di = -reach; di <= reach; ++di)
        {
          const int far = di * di + dj * dj, i = from[0] + di, j = from[1] + dj;
          if (far > least || !cells.exists(i, j) || !cells.areas.interface(i, j))
            continue;
          if (far < least)
            found.clear();
          least = far, found.push_back(cells.number(i, j));
        }
      return found;
    }

    // The first cell of `gathered` nearby in the same phase, or this one.
    long gathering_place(const Cells &cells, const medium::CellValues &gathered,
                         const std::array<int, 2> &from)
    {
      constexpr int reach = 8;
      for (const medium::CellValue &other : gathered)
      {
        const std::array<int, 2> at = cells.indices(other.cell);
        if (std::max(std::abs(at[0] - from[0]), std::abs(at[1] - from[1])) <= reach &&
            cells.areas.corners(at[0], at[1]) == cells.areas.corners(from[0], from[1]))
          return other.cell;
      }
      return cells.number(from[0], from[1]);
    }

    void collect(medium::CellValues &values)
    {
      std::stable_sort(values.begin(), values.end(),
                       [](const auto &a, const auto &b) { return a.cell < b.cell; });
      medium::CellValues sums;
      for (const medium::CellValue &value : values)
        if (!sums.empty() && sums.back().cell == value.cell)
          sums.back().value += value.value;
        else
          sums.push_back(value);
      values.swap(sums);
    }
  } // namespace

  medium::CellValues merged(const medium::CellValues &a, const medium::CellValues &b)
  {
    medium::CellValues sum;
    sum.reserve(a.size() + b.size());
    auto p = a.begin(), q = b.begin();
    while (p != a.end() || q != b.end())
    {
      const bool first = q == b.end() || (p != a.end() && p->cell <= q->cell);
      const bool second = p == a.end() || (q != b.end() && q->cell <= p->cell);
      const double value = (first ? p->value : 0.) + (second ? q->value : 0.);
      if (value != 0.)
        sum.push_back({first ? p->cell : q->cell, value});
      p += first ? 1 : 0, q += second ? 1 : 0;
    }
    return sum;
  }

  void transfer_owed_area(medium::CellValues &owed, const medium::CellAreas &areas,
                          const std::array<int, 2> &count)
  {
    const Cells cells{areas, count};
    medium::CellValues moved, gathered;
    for (const medium::CellValue &debt : owed)
    {
      const std::array<int, 2> at = cells.indices(debt.cell);
      if (areas.interface(at[0], at[1]))
      {
        moved.push_back({cells.number(at[0], at[1]), debt.value});
        continue;
      }
      const std::vector<long> nearest = nearest_interfaces(cells, at);
      for (const long cell : nearest) // equal shares keep what is symmetric so
        moved.push_back({cell, debt.value / static_cast<double>(nearest.size())});
      if (nearest.empty())
        gathered.push_back({gathering_place(cells, gathered, at), debt.value});
    }
    moved.insert(moved.end(), gathered.begin(), gathered.end());
    collect(moved);
    owed.swap(moved);
  }

  namespace
  {
    // The numbers of a checkpoint, in its order.
    template <typename SolidOrConst, typename F>
    void for_each_count(SolidOrConst &solid, F &&f)
    {
      auto &budget = solid.growing->budget;
      f(budget.activated), f(budget.grown), f(budget.melted), f(budget.seeded), f(budget.removed);
      f(budget.seeded_points), f(budget.removed_points), f(solid.split_points);
    }
  } // namespace

  std::vector<double> pack_growth(const Solid &solid)
  {
    std::vector<double> packed;
    for_each_count(solid, [&](const auto &count) { packed.push_back(static_cast<double>(count)); });
    for (const medium::CellValue &debt : solid.growing->owed)
      packed.insert(packed.end(), {static_cast<double>(debt.cell), debt.value});
    return packed;
  }

  void unpack_growth(Solid &solid, const std::vector<double> &packed)
  {
    if (packed.size() < 8 || packed.size() % 2 != 0)
      throw std::runtime_error("the checkpoint's ledger of growth is cut short");
    solid.growing = std::make_unique<Growing>(solid.domain);
    std::size_t k = 0;
    for_each_count(solid, [&](auto &count)
                   { count = static_cast<std::decay_t<decltype(count)>>(packed[k++]); });
    for (; k < packed.size(); k += 2)
      solid.growing->owed.push_back({static_cast<long>(packed[k]), packed[k + 1]});
  }

  std::size_t insert_point(Solid &solid, const Point &position, const double mass)
  {
    Points &points = solid.points;
    add_point(points, solid.fraction, position, mass);
    const std::size_t last = points.size() - 1, place = points.active++;
    if (place != last)
      for_each_array(points,
                     [&](const char *, auto &array) { std::swap(array[place], array[last]); });
    if (points.may_split)
      points.rxx[place] = points.ryy[place] =
          static_cast<float>(std::sqrt(mass / solid.material.density));
    solid.grid.drift = solid.grid.dx; // sort before the next step
    return place;
  }

  void erase_points(Solid &solid, const std::vector<std::size_t> &which)
  {
    if (which.empty())
      return;
    Points &points = solid.points;
    for_each_array(points,
                   [&](const char *, auto &array)
                   {
                     std::size_t to = 0, next = 0;
                     for (std::size_t p = 0; p < array.size(); ++p)
                       if (next < which.size() && which[next] == p)
                         ++next;
                       else
                         array[to++] = array[p];
                     array.resize(to);
                   });
    points.active -= which.size();
    solid.grid.drift = solid.grid.dx;
  }

  AreaBudget area_budget(const Solid &solid)
  {
    if (!solid.growing)
      return {};
    AreaBudget now = solid.growing->budget;
    now.points = mass(solid) / solid.material.density;
    for (const medium::CellValue &debt : solid.growing->owed)
      now.owed += debt.value;
    now.phi = solid.growing->map.total(), now.split_points = solid.split_points;
    return now;
  }

  History growth_history(const Solid &solid)
  {
    const AreaBudget now = area_budget(solid);
    History history;
    history.names = {"grown_area", "melted_area",   "owed_area",      "area_imbalance",
                     "area_drift", "seeded_points", "removed_points", "split_points"};
    using scene::Dimension;
    history.dimensions = {Dimension::area, Dimension::area, Dimension::area, Dimension::area,
                          Dimension::none, Dimension::none, Dimension::none, Dimension::none};
    history.row = {now.grown,
                   now.melted,
                   now.owed,
                   now.imbalance(),
                   now.phi > 0. ? (area(solid) + now.owed) / now.phi - 1. : 0.,
                   static_cast<double>(now.seeded_points),
                   static_cast<double>(now.removed_points),
                   static_cast<double>(now.split_points)};
    return history;
  }
} // namespace solid
