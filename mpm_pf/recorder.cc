#include "recorder.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "melt/thin_interface.h"
#include "observe.h"
#include "record/stopwatch.h"
#include "recorded_times.h"
#include "scene/schedule.h"
#include "scene/units.h"
#include "solid/moving_walls.h"

Recorder::Recorder(const scene::Scene &scene, record::Writer &out)
    : writer(out), tolerance(1e-9 * scene.clock.end), events(recorded_times(scene))
{
  const double end = scene.clock.end;
  if (scene.growth && scene.heat)
    interface_warning =
        melt::width_warning(scene.growth->capillary_length, scene.phase_field->width);
  if (scene.phase_field && interface_warning.empty())
    interface_warning = melt::profile_warning(
        scene.phase_field->width, scene.domain.spacing().maxCoeff(), scene.growth.has_value());
  for (const auto &probe : scene.probes)
    if (!std::holds_alternative<scene::ReactionProbe>(probe.kind))
      scheduled_probes.push_back({&probe, scene::sample_times(probe, end), 0});
  for (const AskedReaction &asked : asked_reactions(scene))
  {
    ReactionWindow window(asked.sampling);
    std::vector<double> own = apart_by(tolerance, window.events());
    reactions.push_back({asked.name, asked.support, std::move(window), std::move(own), 0});
  }
}

double Recorder::next_event(const double time) const
{
  const auto next = std::upper_bound(events.begin(), events.end(), time + tolerance);
  return next == events.end() ? std::numeric_limits<double>::infinity() : *next;
}

bool Recorder::reaches_time(const std::vector<double> &times, const std::size_t next,
                            const double time) const
{
  return next < times.size() && times[next] <= time + tolerance;
}

bool Recorder::reaches_compression(const ScheduledProbe &scheduled, const World &world) const
{
  const auto &wanted = scheduled.probe->compressions;
  if (!world.walls || scheduled.next >= wanted.size())
    return false;
  const auto &walls = world.walls->walls;
  const bool touched =
      std::any_of(walls.begin(), walls.end(),
                  [](const medium::Wall &wall) { return wall.touched.has_value(); });
  return touched && medium::compression(*world.walls) >= wanted[scheduled.next] * (1. - 1e-9);
}

bool Recorder::is_due(const World &world) const
{
  return std::any_of(scheduled_probes.begin(), scheduled_probes.end(),
                     [&](const ScheduledProbe &scheduled)
                     {
                       return reaches_time(scheduled.times, scheduled.next, world.time) ||
                              reaches_compression(scheduled, world);
                     });
}

void Recorder::observe(const World &world)
{
  const record::PartTimer timer(output);
  for (auto &scheduled : scheduled_probes)
    if (reaches_time(scheduled.times, scheduled.next, world.time) ||
        reaches_compression(scheduled, world))
    {
      ++scheduled.next;
      observe_probe(*scheduled.probe, world);
    }
  for (auto &reaction : reactions)
    if (reaches_time(reaction.events, reaction.next, world.time))
    {
      ++reaction.next;
      observe_reaction(reaction, world);
    }
}

void Recorder::observe_early_end(const World &world)
{
  for (auto &scheduled : scheduled_probes)
  {
    if (scheduled.next >= scheduled.times.size())
      continue; // all sampled, or sampled by compression
    if (scheduled.next == 0 || world.time > scheduled.times[scheduled.next - 1] + tolerance)
      observe_probe(*scheduled.probe, world);
    scheduled.next = scheduled.times.size();
  }
  for (auto &reaction : reactions)
  {
    reaction.window.end_early(world.time);
    observe_reaction(reaction, world);
  }
}

double Recorder::next_compression() const
{
  double next = std::numeric_limits<double>::infinity();
  for (const auto &scheduled : scheduled_probes)
    if (const auto &wanted = scheduled.probe->compressions; scheduled.next < wanted.size())
      next = std::min(next, wanted[scheduled.next]);
  return next;
}

void Recorder::observe_probe(const scene::Probe &probe, const World &world)
{
  std::visit(
      [&](const auto &kind)
      {
        if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, scene::TipProbe>)
          observe_tip(kind, probe, world);
        else
          ::observe(kind, probe, world, writer);
      },
      probe.kind);
}

void Recorder::observe_tip(const scene::TipProbe &probe, const scene::Probe &named,
                           const World &world)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const double width = world.scene->phase_field->width;
  const auto &mesh = *world.mesh;
  const double travel = melt::default_travel(mesh);
  const auto tip = melt::find_tip(world.phase->value, mesh, {probe.origin, probe.direction}, width);
  auto &track = tracks[named.name];
  melt::TipVelocity velocity{none, none, none, 0};
  if (tip)
  {
    melt::add_sample(track, world.time, tip->position, travel);
    velocity = melt::tip_velocity(track, travel);
    if (tip->position > 5 * width && tip->radius > 0)
      tip_warning = melt::resolution_warning(tip->radius, mesh, width);
  }
  const std::string length = scene::unit_text(scene::Dimension::length, world.scene->units);
  const record::Columns columns{{"position", "velocity", "velocity_residual", "radius",
                                 "radius_residual", "radius_window", "radius_crossings"},
                                {length,
                                 scene::unit_text(scene::Dimension::speed, world.scene->units),
                                 length, length, length, length, "1"}};
  const auto value = [&](double melt::Tip::*member) { return tip ? (*tip).*member : none; };
  writer.table(named.name, columns, world.time,
               {value(&melt::Tip::position), velocity.value, velocity.residual,
                value(&melt::Tip::radius), value(&melt::Tip::residual), value(&melt::Tip::window),
                tip ? tip->crossings : 0.});
}

void Recorder::observe_reaction(ScheduledReaction &scheduled, const World &world)
{
  auto reaction = solid::reaction(*world.solid, scheduled.support);
  if (world.walls) // which move before the material knows of them
    for (const medium::Wall &wall : world.walls->walls)
      if (solid::wall_name(wall.side) == scheduled.support)
        reaction.displacement[wall.axis()] = wall.position - wall.origin;
  const auto unit = [&](const scene::Dimension dimension)
  { return scene::unit_text(dimension, world.scene->units); };
  const std::string force = unit(scene::Dimension::force), length = unit(scene::Dimension::length);
  const record::Columns columns{{"force_x", "force_y", "displacement_x", "displacement_y"},
                                {force, force, length, length}};
  for (const auto &row : scheduled.window.add(world.time, reaction.impulse, reaction.displacement))
    writer.table(scheduled.name, columns, row.time,
                 {row.force[0], row.force[1], row.displacement[0], row.displacement[1]});
}

void Recorder::save(record::CheckpointTarget &checkpoint) const
{
  for (const auto &scheduled : scheduled_probes)
    checkpoint.put("recorder/" + scheduled.probe->name + "/next",
                   static_cast<double>(scheduled.next));
  for (const auto &reaction : reactions)
    checkpoint.put("recorder/" + reaction.name, reaction.window.state());
  for (const auto &[name, track] : tracks)
  {
    checkpoint.put("recorder/" + name + "/time", track.time);
    checkpoint.put("recorder/" + name + "/position", track.position);
  }
}

void Recorder::restore(const record::Checkpoint &checkpoint, const double time)
{
  const auto passed = [&](const std::vector<double> &times)
  {
    return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time + tolerance) -
                                    times.begin());
  };
  for (auto &scheduled : scheduled_probes)
  {
    const std::string key = "recorder/" + scheduled.probe->name;
    scheduled.next = static_cast<std::size_t>(checkpoint.number(key + "/next"));
    if (checkpoint.has(key + "/time"))
      tracks[scheduled.probe->name] = {checkpoint.get<double>(key + "/time"),
                                       checkpoint.get<double>(key + "/position")};
  }
  for (auto &reaction : reactions)
  {
    reaction.next = passed(reaction.events);
    reaction.window.restore(checkpoint.get<double>("recorder/" + reaction.name));
  }
}
