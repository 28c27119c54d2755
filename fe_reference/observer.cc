#include "observer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "overlap.h"
#include "record/stopwatch.h"
#include "scene/geometry.h"
#include "scene/quantities.h"
#include "scene/schedule.h"
#include "scene/units.h"

namespace fe
{
  namespace
  {
    // The melt's quantities of a passive marker are left to those who know a melt.
    std::vector<std::string> names_of(const scene::Probe &probe)
    {
      std::vector<std::string> names;
      std::copy_if(probe.of.begin(), probe.of.end(), std::back_inserter(names),
                   [](const std::string &name) { return !scene::is_melt_quantity(name); });
      if (!probe.of.empty())
        return names;
      return {"von_mises", "plastic_strain", "pressure", "stress_xx",      "stress_yy",
              "stress_zz", "stress_xy",      "jacobian", "displacement_x", "displacement_y"};
    }

    std::vector<scene::Probe> unasked_reactions(const scene::Scene &scene)
    {
      std::vector<scene::Probe> probes;
      for (const scene::Support &support : scene.supports)
      {
        const bool asked = std::any_of(scene.probes.begin(), scene.probes.end(),
                                       [&](const scene::Probe &probe)
                                       {
                                         const auto *reaction =
                                             std::get_if<scene::ReactionProbe>(&probe.kind);
                                         return reaction && reaction->support == support.name;
                                       });
        if (asked)
          continue;
        scene::Probe probe;
        probe.name = "reaction " + support.name;
        probe.kind = scene::ReactionProbe{support.name};
        probes.push_back(probe);
      }
      return probes;
    }

    bool samples_instants(const scene::Probe &probe)
    {
      return !std::holds_alternative<scene::ReactionProbe>(probe.kind) &&
             !std::holds_alternative<scene::HistoryProbe>(probe.kind);
    }
  } // namespace

  Observer::Observer(const scene::Scene &scene_, const Problem &problem_, record::Writer *writer_)
      : scene(scene_), problem(problem_), writer(writer_), own(unasked_reactions(scene_)),
        tolerance(1e-9 * scene_.clock.end)
  {
    const Discretisation &d = problem.mesh;
    const std::vector<int> &piece = problem.supports.piece;
    several_pieces = std::count(piece.begin(), piece.end(), piece.front()) < d.nodes;
    default_bin = scene::default_bin(scene);
    const auto scheduled = [this](const scene::Probe &probe)
    {
      scheduled_probes.push_back({&probe, scene::sample_times(probe, scene.clock.end), false});
      const std::vector<double> &times = scheduled_probes.back().times;
      events.insert(events.end(), times.begin(), times.end());
    };
    std::for_each(scene.probes.begin(), scene.probes.end(), scheduled);
    energy_asked = std::any_of(scene.probes.begin(), scene.probes.end(),
                               [](const scene::Probe &probe) { return probe.name == "energy"; });
    for (const scene::Probe &probe : own)
      scheduled_probes.push_back({&probe, {}, true});
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end(),
                             [this](const double a, const double b) { return b - a <= tolerance; }),
                 events.end());
  }

  bool Observer::due(const ScheduledProbe &scheduled, const double time) const
  {
    return scheduled.every_step ||
           std::any_of(scheduled.times.begin(), scheduled.times.end(),
                       [&](const double sample) { return std::abs(sample - time) <= tolerance; });
  }

  void Observer::observe(const Step &step)
  {
    const record::PartTimer timer(output);
    monitor_folding(step);
    if (several_pieces)
      overlapping = overlap_of_pieces(problem.mesh, problem.supports.piece, step.state.u);
    overlap_time = step.state.time;
    const bool whole =
        std::any_of(scheduled_probes.begin(), scheduled_probes.end(),
                    [&](const ScheduledProbe &scheduled) {
                      return samples_instants(*scheduled.probe) && due(scheduled, step.state.time);
                    });
    std::optional<Snapshot> body;
    if (whole)
      body.emplace(snapshot_of(step));
    on_first_process(
        [&]
        {
          if (!energy_asked)
            history_row("energy", step);
          for (const ScheduledProbe &scheduled : scheduled_probes)
            if (!due(scheduled, step.state.time))
              continue;
            else if (const auto *reaction =
                         std::get_if<scene::ReactionProbe>(&scheduled.probe->kind))
              reaction_row(scheduled.probe->name, reaction->support, step.state);
            else if (std::holds_alternative<scene::HistoryProbe>(scheduled.probe->kind))
              history_row(scheduled.probe->name, step);
            else
              observe_probe(*scheduled.probe, *body, step.state);
        });
  }

  Snapshot Observer::snapshot_of(const Step &step) const
  {
    Snapshot body = make_snapshot(problem, step.state, step.before);
    const double rounding = matching_tolerance(scene::bounding_box(scene.bodies));
    body.starts_in = [this, rounding](const Point &X)
    { return scene::signed_distance(scene.bodies, X) >= -rounding; };
    return body;
  }

  void Observer::observe_last(const Step &step)
  {
    const record::PartTimer timer(output);
    const Snapshot body = snapshot_of(step);
    on_first_process(
        [&]
        {
          for (const ScheduledProbe &scheduled : scheduled_probes)
            if (samples_instants(*scheduled.probe) && !due(scheduled, step.state.time))
              observe_probe(*scheduled.probe, body, step.state);
        });
  }

  void Observer::monitor_folding(const Step &step)
  {
    double smallest = 1.;
    const std::vector<char> folded = folded_cells(problem, step.state.u, smallest);
    smallest_nodal = smallest;
    folded_now = static_cast<int>(std::count(folded.begin(), folded.end(), 1));
    if (folds.cell >= 0)
      return;
    if (folded_now == 0)
    {
      folds.last_valid = step.state.time;
      return;
    }
    folds.time = step.state.time;
    folds.cell = static_cast<int>(std::find(folded.begin(), folded.end(), 1) - folded.begin());
  }

  std::string Observer::first_folding() const
  {
    if (folds.cell < 0)
      return "";
    Point X = Point::Zero();
    for (int a = 0; a < 4; ++a)
      X += 0.25 * problem.mesh.position[problem.mesh.nodes_of(folds.cell)[a]];
    std::ostringstream text;
    text << "t = " << folds.time << ", cell at X = (" << X[0] << ", " << X[1] << ")";
    return text.str();
  }

  std::string Observer::overlap() const
  {
    if (!overlapping)
      return "";
    std::ostringstream text;
    text << "bodies lie in each other at t = " << overlap_time << " near x = (" << (*overlapping)[0]
         << ", " << (*overlapping)[1]
         << "): fe_reference knows no contact. Remedy: end the scene before they meet, or run it "
            "with mpm_pf alone";
    return text.str();
  }

  std::string Observer::self_overlap(const State &state) const
  {
    double smallest = 0.;
    const std::vector<char> folded = folded_cells(problem, state.u, smallest);
    const std::optional<Point> at =
        overlap_with_itself(problem.mesh, problem.supports.piece, state.u, folded);
    if (!at)
      return "";
    std::ostringstream text;
    text << "near x = (" << (*at)[0] << ", " << (*at)[1] << ")";
    return text.str();
  }

  void Observer::history_row(const std::string &name, const Step &step)
  {
    if (!writer)
      return;
    const std::string energy = scene::unit_text(scene::Dimension::energy, scene.units);
    const Energies &e = step.stepping.energies;
    double area = 0.;
    const Discretisation &d = problem.mesh;
    for (const BoundarySide &side : d.boundary) // area by Green's theorem over the outline
      for (int k = 0; k < d.degree; ++k)
      {
        const auto at = [&](const int node) {
          return Point(d.position[node] +
                       Point(step.state.u[2 * node], step.state.u[2 * node + 1]));
        };
        const Point a = at(side.node[k]), b = at(side.node[k + 1]);
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        if (d.degree == 2 && k == 0) // the two arcs between chords and parabola
        {
          const Point c = at(side.node[2]);
          const Point ab = b - a, ac = c - a;
          area += (ab[0] * ac[1] - ab[1] * ac[0]) / 6.;
        }
      }
    writer->table(name,
                  {{"external_work", "internal_work", "elastic_energy", "plastic_work",
                    "smallest_jacobian", "smallest_nodal_jacobian", "folded_cells", "area",
                    "load_factor", "newton_iterations", "residual"},
                   {energy, energy, energy, energy, "1", "1", "1",
                    scene::unit_text(scene::Dimension::area, scene.units), "1", "1", "1"}},
                  step.state.time,
                  {e.external, e.elastic + e.plastic, e.elastic, e.plastic,
                   step.state.smallest_jacobian, smallest_nodal, static_cast<double>(folded_now),
                   area, step.state.time / scene.clock.end,
                   static_cast<double>(step.newton.iterations),
                   step.newton.residuals.empty() ? 0. : step.newton.residuals.back()});
  }

  void Observer::reaction_row(const std::string &name, const std::string &support,
                              const State &state)
  {
    if (!writer)
      return;
    for (const Supports::Held &held : problem.supports.held)
    {
      if (held.name != support)
        continue;
      std::vector<double> row(4, 0.);
      for (int c = 0; c < 2; ++c) // a component that is left free has no displacement of its own
        for (const int n : held.nodes[c])
        {
          row[c] += state.internal[2 * n + c] - state.external[2 * n + c];
          row[2 + c] += state.u[2 * n + c] / static_cast<double>(held.nodes[c].size());
        }
      const std::string force = scene::unit_text(scene::Dimension::force, scene.units);
      const std::string length = scene::unit_text(scene::Dimension::length, scene.units);
      writer->table(name,
                    {{"force_x", "force_y", "displacement_x", "displacement_y"},
                     {force, force, length, length}},
                    state.time, row);
      return;
    }
  }

  void Observer::observe_probe(const scene::Probe &probe, const Snapshot &body, const State &state)
  {
    if (!writer)
      return;
    const std::vector<std::string> names = names_of(probe);
    if (names.empty())
      return;
    const record::Columns columns = columns_of(names, scene.units);
    if (const auto *line = std::get_if<scene::LineProbe>(&probe.kind))
      writer->line(probe.name, columns, state.time, sample_line(body, *line, names, default_bin));
    else if (const auto *point = std::get_if<scene::PointProbe>(&probe.kind))
      writer->table(probe.name, columns, state.time,
                    sample_point(body, *point, names, default_bin));
    else if (const auto *region = std::get_if<scene::RegionProbe>(&probe.kind))
      writer->table(probe.name, columns, state.time, region_means(body, *region, names));
    else if (const auto *outline = std::get_if<scene::OutlineProbe>(&probe.kind))
    {
      if (outline->of == scene::OutlineProbe::Of::material)
        writer->outline(probe.name, state.time, outlines(body));
    }
    else if (std::holds_alternative<scene::SnapshotProbe>(probe.kind))
      writer->snapshot(probe.name, state.time, cell_snapshot(body, names));
  }
} // namespace fe
