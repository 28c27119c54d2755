#include "medium/area_map.h"

#include <algorithm>

namespace medium
{
  namespace
  {
    constexpr int chunk = 32; // cells of a row that are looked at together
  }

  AreaMap::AreaMap(const Mesh &mesh)
      : cells{mesh.nodes[0] - 1, mesh.nodes[1] - 1}, chunks((cells[0] + chunk - 1) / chunk),
        area(static_cast<std::size_t>(cells[0]) * cells[1], 0.),
        state(static_cast<std::size_t>(chunks) * cells[1], empty)
  {
  }

  template <typename F>
  void AreaMap::set(const CellAreas &areas, const int i, const int j, F &&changed)
  {
    const long cell = static_cast<long>(j) * cells[0] + i;
    const double now = areas.area(i, j), before = area[static_cast<std::size_t>(cell)];
    if (now != before)
      changed(cell, now - before);
    area[static_cast<std::size_t>(cell)] = now;
  }

  template <typename F>
  void AreaMap::update(const Field<double> &phi, const Mesh &mesh,
                       const std::optional<scene::Box> &active, F &&changed)
  {
    const CellAreas areas(phi, mesh, active);
    range = {areas.first_cell(0), areas.end_cell(0), areas.first_cell(1), areas.end_cell(1)};
    for (int j = range[2]; j < range[3]; ++j)
      for (int c = range[0] / chunk; c * chunk < range[1]; ++c)
      {
        const int begin = std::max(c * chunk, range[0]), end = std::min((c + 1) * chunk, range[1]);
        std::uint8_t &known = state[static_cast<std::size_t>(j) * chunks + c];
        std::uint8_t now = mixed;
        if (!areas.cut(1, j) && !areas.cut(0, begin) && !areas.cut(0, end - 1))
        {
          const double *const row = phi.row(j), *const above = phi.row(j + 1);
          int solid = 0;
          for (int i = begin; i <= end; ++i)
            solid += (row[i] > 0.) + (above[i] > 0.);
          now = solid == 0 ? empty : solid == 2 * (end - begin + 1) ? full : mixed;
        }
        if (now == mixed || now != known)
          for (int i = begin; i < end; ++i)
            set(areas, i, j, changed);
        // A chunk that a wall has cut off is not known as a whole.
        known = end - begin == std::min(chunk, cells[0] - c * chunk) ? now : std::uint8_t(mixed);
      }
  }

  void AreaMap::measure(const Field<double> &phi, const Mesh &mesh,
                        const std::optional<scene::Box> &active)
  {
    update(phi, mesh, active, [](long, double) {});
  }

  CellValues AreaMap::change(const Field<double> &phi, const Mesh &mesh,
                             const std::optional<scene::Box> &active)
  {
    CellValues changes;
    update(phi, mesh, active,
           [&](const long cell, const double value) {
             changes.push_back({cell, value});
           });
    return changes;
  }

  double AreaMap::total() const
  {
    double sum = 0.;
    for (int j = range[2]; j < range[3]; ++j)
      for (int i = range[0]; i < range[1]; ++i)
        sum += at(i, j);
    return sum;
  }

  double solid_area(const Field<double> &phi, const Mesh &mesh,
                    const std::optional<scene::Box> &active)
  {
    AreaMap map(mesh);
    map.measure(phi, mesh, active);
    return map.total();
  }
} // namespace medium
