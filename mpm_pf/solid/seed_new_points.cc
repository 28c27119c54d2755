#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "solid/area_budget.h"
#include "solid/energy.h"

namespace solid
{
  namespace
  {
    // A new point moves with the solid around it; what that brings in is no work of supports.
    void add_grown_point(Solid &solid, const Point &at, const double area)
    {
      const bool moving = !solid.grid.nodes.empty();
      const Point v = moving ? transferred_velocity(solid.interpolation(), at) : Point(0., 0.);
      const std::size_t p = insert_point(solid, at, solid.material.density * area);
      solid.points.vx[p] = v[0], solid.points.vy[p] = v[1];
      solid.energy.start += kinetic_energy_of(solid.points, p);
      AreaBudget &budget = solid.growing->budget;
      budget.seeded += area, ++budget.seeded_points;
    }

    // On the contour in the cell, or in the middle of a cell that became solid as a whole. Where
    // more than a point's share has come at once, several points share it.
    void seed_cell(Solid &solid, const medium::CellAreas &areas, medium::CellValue &debt)
    {
      const int i = static_cast<int>(debt.cell % solid.grid.cells[0]);
      const int j = static_cast<int>(debt.cell / solid.grid.cells[0]);
      const medium::CellPart part = areas.part(i, j);
      if (part.pieces == 0)
        return;
      const double least = least_share * solid.grid.dx * solid.grid.dx;
      const int count = std::min(4, static_cast<int>(debt.value / least));
      const scene::Box cell = areas.box(i, j);
      scene::Segment line{cell.lower, cell.upper};
      if (part.segments > 0)
        line = part.segment[0];
      const Point inset = 1e-3 * (cell.upper - cell.lower);
      for (int k = 0; k < count; ++k)
      {
        const Point at = line.a + (k + 0.5) / count * (line.b - line.a);
        add_grown_point(solid, at.cwiseMax(cell.lower + inset).cwiseMin(cell.upper - inset),
                        debt.value / count);
      }
      debt.value = 0.;
    }

    // Cells in which points answer for a debt. Where nothing solid is left the debts of many cells
    // have been gathered in one (area_budget.cc), and its points may stand further away.
    int melting_reach(const medium::CellValue &debt, const medium::CellAreas &areas,
                      const Grid &grid)
    {
      const unsigned corners = areas.corners(static_cast<int>(debt.cell % grid.cells[0]),
                                             static_cast<int>(debt.cell / grid.cells[0]));
      return corners == 0u ? 12 : 4;
    }

    using Buckets = std::unordered_map<long, std::vector<std::size_t>>;

    // Call f(number) for the cells of the domain at most `reach` from `cell` each way.
    template <typename F>
    void for_square(const std::array<int, 2> &cells, const long cell, const int reach, F &&f)
    {
      const int i = static_cast<int>(cell % cells[0]), j = static_cast<int>(cell / cells[0]);
      for (int b = std::max(0, j - reach); b <= std::min(cells[1] - 1, j + reach); ++b)
        for (int a = std::max(0, i - reach); a <= std::min(cells[0] - 1, i + reach); ++a)
          f(static_cast<long>(b) * cells[0] + a);
    }

    // Points answer for half of the least share; where nothing solid is left, for any debt.
    bool melts(const medium::CellValue &debt, const medium::CellAreas &areas, const Grid &grid)
    {
      const double cell = grid.dx * grid.dx;
      if (debt.value > -0.5 * least_share * cell)
        return debt.value < -1e-9 * cell &&
               areas.corners(static_cast<int>(debt.cell % grid.cells[0]),
                             static_cast<int>(debt.cell / grid.cells[0])) == 0u;
      return true;
    }

    // Sorting again for every single point would cost more than waiting: a fifth of a percent of
    // all points at once, or as soon as a cell owes a second share.
    bool worth_it(const Solid &solid, const medium::CellAreas &areas, const double least)
    {
      std::size_t due = 0;
      for (const medium::CellValue &debt : solid.growing->owed)
      {
        if (debt.value < 0. && debt.value > -0.5 * least && melts(debt, areas, solid.grid))
          return true;
        due += std::abs(debt.value) >= least ? 1 : 0;
        if (std::abs(debt.value) >= 2. * least)
          return true;
      }
      return 500 * due >= solid.points.size() && due > 0;
    }

    // The points near cells that owe a negative area, by their cell.
    Buckets points_near(const Solid &solid, const medium::CellAreas &areas)
    {
      const auto &cells = solid.grid.cells;
      Buckets buckets;
      for (const medium::CellValue &debt : solid.growing->owed)
        if (melts(debt, areas, solid.grid))
          for_square(cells, debt.cell, melting_reach(debt, areas, solid.grid),
                     [&](const long cell) { buckets[cell]; });
      if (buckets.empty())
        return buckets;
      for (std::size_t p = 0; p < solid.points.active; ++p)
      {
        const long cell = static_cast<long>(solid.grid.cell(solid.points.y[p], 1)) * cells[0] +
                          solid.grid.cell(solid.points.x[p], 0);
        if (const auto bucket = buckets.find(cell); bucket != buckets.end())
          bucket->second.push_back(p);
      }
      return buckets;
    }

    struct Candidate
    {
      double phi;
      std::size_t point;
      bool operator<(const Candidate &other) const
      {
        return phi != other.phi ? phi < other.phi : point < other.point;
      }
    };

    // Points that a fast front has left behind in the melt, wherever within reach; else those of
    // the smallest square of cells around the debt that has any. Outermost first.
    std::vector<Candidate> outermost(const Solid &solid, const medium::CellAreas &areas,
                                     const Buckets &buckets, const std::vector<char> &gone,
                                     const medium::CellValue &debt)
    {
      constexpr double in_the_melt = -0.5; // phi
      const int furthest = melting_reach(debt, areas, solid.grid);
      std::vector<Candidate> found;
      const auto look = [&](const int reach, const double highest)
      {
        for_square(solid.grid.cells, debt.cell, reach,
                   [&](const long near)
                   {
                     for (const std::size_t p : buckets.at(near))
                       if (const double phi = areas.value({solid.points.x[p], solid.points.y[p]});
                           !gone[p] && phi < highest)
                         found.push_back({phi, p});
                   });
      };
      look(furthest, in_the_melt);
      for (int reach = 1; reach <= furthest && found.empty(); ++reach)
        look(reach, 2.);
      std::sort(found.begin(), found.end());
      return found;
    }

    // Neighbours may answer with the same point. Whoever owes most has the next one: an order by
    // cells would take other points from a crystal than from its mirror image.
    struct OwesLess
    {
      bool operator()(const medium::CellValue *a, const medium::CellValue *b) const
      {
        return a->value != b->value ? a->value > b->value : a->cell > b->cell;
      }
    };
    using Debtors =
        std::priority_queue<medium::CellValue *, std::vector<medium::CellValue *>, OwesLess>;

    void take_away(Solid &solid, const std::size_t p, medium::CellValue &debt)
    {
      AreaBudget &budget = solid.growing->budget;
      // phi melts what is there now, strained as it is; the budget counts it without stress.
      const double area = solid.points.mass[p] / solid.material.density;
      const double area_now = area * solid.points.jacobian[p];
      debt.value += area_now;
      budget.melted += area - area_now;
      const double elastic = elastic_energy_of(solid, p);
      solid.energy.start -= kinetic_energy_of(solid.points, p) + elastic;
      solid.energy.elastic_start -= elastic;
      budget.removed += area, ++budget.removed_points;
    }
  } // namespace

  void remove_melted_points(Solid &solid, const medium::CellAreas &areas)
  {
    Growing &growing = *solid.growing;
    const Buckets buckets = points_near(solid, areas);
    if (buckets.empty())
      return;
    std::vector<char> gone(solid.points.active, 0);
    std::vector<std::size_t> removed;
    Debtors debtors;
    for (medium::CellValue &debt : growing.owed)
      if (melts(debt, areas, solid.grid))
        debtors.push(&debt);
    while (!debtors.empty())
    {
      medium::CellValue &debt = *debtors.top();
      debtors.pop();
      const std::vector<Candidate> candidates = outermost(solid, areas, buckets, gone, debt);
      if (candidates.empty())
        continue;
      const std::size_t p = candidates.front().point;
      const double area = solid.points.mass[p] / solid.material.density * solid.points.jacobian[p];
      if (-debt.value < 0.5 * area * (1. - 1e-9))
        continue;
      take_away(solid, p, debt);
      gone[p] = 1, removed.push_back(p);
      if (debt.value < 0.)
        debtors.push(&debt);
    }
    std::sort(removed.begin(), removed.end());
    erase_points(solid, removed);
  }

  void begin_growth(Solid &solid, const Crystal &crystal)
  {
    if (solid.growing)
      solid.growing->map.measure(crystal.phi, crystal.mesh, crystal.between_walls);
  }

  void seed_new_points(Solid &solid, const Crystal &crystal)
  {
    if (!solid.growing)
      return;
    Growing &growing = *solid.growing;
    const medium::CellValues change =
        growing.map.change(crystal.phi, crystal.mesh, crystal.between_walls);
    for (const medium::CellValue &cell : change)
      (cell.value > 0. ? growing.budget.grown : growing.budget.melted) += std::abs(cell.value);
    growing.owed = merged(growing.owed, change);
    const medium::CellAreas areas(crystal.phi, crystal.mesh, crystal.between_walls);
    transfer_owed_area(growing.owed, areas, solid.grid.cells);
    const double least = least_share * solid.grid.dx * solid.grid.dx;
    if (!worth_it(solid, areas, least))
      return;
    remove_melted_points(solid, areas);
    for (medium::CellValue &debt : growing.owed)
      if (debt.value >= least)
        seed_cell(solid, areas, debt);
  }
} // namespace solid
