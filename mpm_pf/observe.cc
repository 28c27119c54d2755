#include "observe.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "inertia.h"
#include "melt_history.h"
#include "melt_samples.h"
#include "scene/quantities.h"
#include "scene/units.h"
#include "solid/growing.h"
#include "solid/moving_walls.h"

namespace
{
  /// Names of a probe's columns, with units in the scene's system.
  record::Columns columns_of(const scene::Probe &probe, const World &world)
  {
    record::Columns columns;
    for (const auto &name : probe.of)
    {
      columns.names.push_back(name);
      columns.units.push_back(scene::column_unit(scene::dimension_of(name), world.scene->units));
    }
    return columns;
  }

  /// Those of a probe's quantities that the material points know.
  std::vector<std::string> of_solid(const scene::Probe &probe, const World &world)
  {
    std::vector<std::string> names;
    if (world.solid)
      std::copy_if(probe.of.begin(), probe.of.end(), std::back_inserter(names),
                   [](const std::string &name) { return !scene::is_melt_quantity(name); });
    return names;
  }

  /// Nothing is there: NaN at nodes behind the walls.
  void blank_behind_walls(std::vector<double> &nodes, const World &world)
  {
    const BetweenWalls between(world);
    std::size_t n = 0;
    for (int j = 0; j < world.mesh->nodes[1]; ++j)
      for (int i = 0; i < world.mesh->nodes[0]; ++i, ++n)
        if (!between.holds(world.mesh->position(i, j)))
          nodes[n] = std::numeric_limits<double>::quiet_NaN();
  }

  /// Copies the nodes of a field, x fastest.
  std::vector<double> nodes_of(const medium::Field<double> &field, const World &world)
  {
    std::vector<double> flat;
    for (int j = 0; j < field.nodes(1); ++j)
      flat.insert(flat.end(), field.row(j), field.row(j) + field.nodes(0));
    if (world.walls)
      blank_behind_walls(flat, world);
    return flat;
  }

  void add(HistoryColumns &row, const solid::History &history, const World &world)
  {
    for (std::size_t k = 0; k < history.row.size(); ++k)
      row.add(history.names[k], scene::column_unit(history.dimensions[k], world.scene->units),
              history.row[k]);
  }

  /// "wall top" -> "wall_top": expressions of a check know columns by such names.
  std::string column_name(std::string name)
  {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  }

  /// Where the walls are, what they have swept, and whether the loading is quasi-static.
  void add_walls(HistoryColumns &row, const World &world)
  {
    row.add("compression", "1", medium::compression(*world.walls));
    const std::string length = scene::unit_text(scene::Dimension::length, world.scene->units);
    row.add("swept_heat", "L/cp " + length + "^2", world.walls->swept_heat);
    // heat_content + swept_heat - swept_phase/2 is kept but for what advection adds to it, which is
    // carried_heat - carried_phase/2 (melt_history.h).
    if (world.phase)
      row.add("swept_phase", length + "^2", world.walls->swept_phase);
    for (const auto &wall : world.walls->walls)
      row.add(column_name(solid::wall_name(wall.side)) + "_position", length, wall.position);
    if (!world.solid)
      return;
    const Inertia now = inertia(world);
    row.add("inertia_travel", length, now.numbers.inertia_travel);
    row.add("inertia_compression", "1", now.compression());
    row.add("force_imbalance", "1", now.numbers.force_imbalance);
    if (!now.opposed)
      row.add("momentum_to_force", "1", now.numbers.momentum_to_force);
  }

  record::Snapshot grid_snapshot(const World &world)
  {
    record::Snapshot snapshot;
    snapshot.kind = record::Snapshot::Kind::grid;
    snapshot.origin = world.mesh->lower;
    snapshot.spacing = world.mesh->spacing;
    snapshot.nodes = world.mesh->nodes;
    if (world.phase)
      snapshot.fields["phi"] = nodes_of(world.phase->value, world);
    if (world.heat)
      snapshot.fields["theta"] = nodes_of(world.heat->value, world);
    if (world.orientation && world.orientation->varying())
      snapshot.fields["crystal_angle"] = nodes_of(world.orientation->angle, world);
    if (world.melt_moves)
    {
      snapshot.fields["velocity_x"] = nodes_of(world.velocity->x, world);
      snapshot.fields["velocity_y"] = nodes_of(world.velocity->y, world);
    }
    return snapshot;
  }
} // namespace

void observe(const scene::LineProbe &line, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  auto sample = sample_melt(world, positions_of(line), probe.of);
  if (const auto names = of_solid(probe, world); !names.empty())
    overlay(sample.values, probe.of, solid::sample_line(*world.solid, line, names).values, names);
  writer.line(probe.name, columns_of(probe, world), world.time, sample);
}

void observe(const scene::PointProbe &point, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  auto values = sample_melt(world, {point.at}, probe.of).values;
  if (const auto names = of_solid(probe, world); !names.empty())
    overlay(values, probe.of, solid::sample_point(*world.solid, point, names), names);
  writer.table(probe.name, columns_of(probe, world), world.time, values);
}

void observe(const scene::RegionProbe &region, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  writer.table(probe.name, columns_of(probe, world), world.time,
               solid::region_means(*world.solid, region, probe.of));
}

void observe(const scene::ReactionProbe &, const scene::Probe &, const World &, record::Writer &)
{
  // Reactions are means over windows: reaction_window.h, driven by the recorder itself.
}

void observe(const scene::OutlineProbe &outline, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  if (outline.of == scene::OutlineProbe::Of::material)
    writer.outline(probe.name, world.time, solid::material_outline(*world.solid));
  else
    writer.outline(probe.name, world.time, phase_contour(world));
}

void observe(const scene::SnapshotProbe &, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  if (const auto names = of_solid(probe, world);
      world.solid && (probe.of.empty() || !names.empty()))
    writer.snapshot(probe.name, world.time, solid::snapshot(*world.solid, names));
  if (world.mesh)
    writer.snapshot(world.solid ? probe.name + " of the melt" : probe.name, world.time,
                    grid_snapshot(world));
}

void observe(const scene::HistoryProbe &, const scene::Probe &probe, const World &world,
             record::Writer &writer)
{
  HistoryColumns row = melt_history(world);
  if (world.walls)
    add_walls(row, world);
  if (world.solid)
    add(row, solid::history(*world.solid), world);
  if (world.solid && world.scene->growth)
    add(row, solid::growth_history(*world.solid), world);
  writer.table(probe.name, {row.names, row.units}, world.time, row.values);
}
