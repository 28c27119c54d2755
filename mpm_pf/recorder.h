// The verb "observe": samples the world where and when the scene's probes ask, and writes the
// record.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "melt/tip.h"
#include "reaction_window.h"
#include "record/checkpoint.h"
#include "record/writer.h"
#include "world.h"

class Recorder
{
public:
  /// Probes of `scene`; rows go to `writer`. Both must outlive the recorder. A scene with supports
  /// always has its reactions recorded: a support that no probe names gets "reaction <support>".
  Recorder(const scene::Scene &, record::Writer &);

  /// The next time after `time` at which some probe is to be sampled; infinity if none does.
  double next_event(double time) const;

  /// The next compression at which some probe is to be sampled; infinity if none does.
  double next_compression() const;

  /// Whether observe() would sample a probe now.
  bool is_due(const World &) const;

  /// Record all that is due at world.time. Call it at the start and after every step.
  void observe(const World &);

  /// A run that walls end before clock.end: what was still to be recorded is recorded now, once.
  void observe_early_end(const World &);

  /// Time spent observing.
  const record::Profile::Part &cost() const { return output; }

  /// What the program has to say about its own resolution; empty if nothing.
  const std::string &warning() const
  {
    return interface_warning.empty() ? tip_warning : interface_warning;
  }

  void save(record::CheckpointTarget &) const;
  void restore(const record::Checkpoint &, double time);

private:
  struct ScheduledProbe
  {
    const scene::Probe *probe;
    std::vector<double> times;
    std::size_t next = 0;
  };
  struct ScheduledReaction
  {
    std::string name, support;
    ReactionWindow window;
    std::vector<double> events;
    std::size_t next = 0;
  };
  bool reaches_time(const std::vector<double> &times, std::size_t next, double time) const;
  bool reaches_compression(const ScheduledProbe &, const World &) const;
  void observe_probe(const scene::Probe &, const World &);
  void observe_tip(const scene::TipProbe &, const scene::Probe &, const World &);
  void observe_reaction(ScheduledReaction &, const World &);

  record::Writer &writer;
  double tolerance;
  std::vector<double> events; // sorted, unique
  std::vector<ScheduledProbe> scheduled_probes;
  std::vector<ScheduledReaction> reactions;
  std::map<std::string, melt::TipTrack> tracks; // of tip probes, by name
  std::string interface_warning; // too wide or too narrow an interface, known from the scene
  std::string tip_warning;       // the last warning about a tip
  record::Profile::Part output{"output"};
};
