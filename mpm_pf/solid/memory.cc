// Bytes that a solid holds, by part; what its scene does not name holds none.
#include "solid/body.h"

namespace solid
{
  namespace
  {
    template <typename Vector>
    double bytes(const Vector &values)
    {
      return static_cast<double>(values.size() * sizeof(values[0]));
    }

    double grid_bytes(const Solid &solid)
    {
      const Grid &grid = solid.grid;
      const double per_node =
          sizeof(double) + sizeof(Node) + sizeof(Velocity) + 1. +
          (grid.change.empty() ? 0. : sizeof(Velocity)) +
          (solid.cells.mean.empty() ? 0. : 2. * sizeof(CellMeans::Sum) + sizeof(CellMeans::Mean));
      return per_node * static_cast<double>(grid.nodes.size());
    }

    double supports_bytes(const Supports &supports)
    {
      double sum = bytes(supports.all) + bytes(supports.lines) + bytes(supports.edges) +
                   bytes(supports.grips) + bytes(supports.driven) + bytes(supports.driven_parts) +
                   bytes(supports.prescribed) + bytes(supports.tied) + bytes(supports.listed) +
                   bytes(supports.folds.lines) + bytes(supports.folds.pairs) +
                   bytes(supports.marked);
      for (const HeldLine &line : supports.lines)
        sum += bytes(line.touched) + bytes(line.stuck);
      for (const TurningEdge &edge : supports.edges)
        sum += bytes(edge.nodes);
      return sum;
    }

    double tracers_bytes(const Tracers &tracers)
    {
      double sum = bytes(tracers.outlines);
      for (const auto &outline : tracers.outlines)
        sum += bytes(outline);
      return sum;
    }
  } // namespace

  std::map<std::string, double> memory(const Solid &solid)
  {
    const SortScratch &scratch = solid.scratch;
    const Loads &loads = solid.loads;
    std::map<std::string, double> held{
        {"points",
         static_cast<double>(bytes_per_point(solid.points.may_split) * solid.points.size())},
        {"grid", grid_bytes(solid)},
        {"scratch", bytes(scratch.key) + bytes(scratch.order) + bytes(scratch.count) +
                        bytes(scratch.values) + bytes(solid.cells.cell)}};
    const std::map<std::string, double> asked_for{
        {"supports", supports_bytes(solid.supports)},
        {"tractions", bytes(loads.tractions) + bytes(loads.nodal_forces) + bytes(loads.on_grips) +
                          loads.shares.bytes()},
        {"body force", (loads.body_force ? sizeof(*loads.body_force) : 0.) +
                           bytes(loads.acceleration.x) + bytes(loads.acceleration.y)},
        {"tracers", tracers_bytes(solid.tracers)}};
    for (const auto &[part, size] : asked_for)
      if (size > 0.)
        held[part] = size;
    return held;
  }
} // namespace solid
