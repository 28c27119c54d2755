// The verb "observe" for the finite elements: probes, reactions and energies into the record.
//
// Rows stand at the times of scene::sample_times, which the march meets exactly, so that both
// solvers' tables have the same rows; the table "energy" has one row per load step unless a history
// of that name is asked for. Only process 0 writes; all take part in gathering.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "load_stepping.h"
#include "record/writer.h"
#include "sampling.h"

namespace fe
{
  /// The first cell with a node at which the volume ratio is not positive. From then on the answer
  /// is valid away from such cells only.
  struct Folding
  {
    double last_valid = 0.; // last time without one
    double time = 0.;       // of the first one
    int cell = -1;          // the first one; -1: none yet
  };

  class Observer
  {
  public:
    /// `writer` is null on all processes but 0. All must outlive the observer.
    Observer(const scene::Scene &, const Problem &, record::Writer *writer);

    /// All times at which some probe is sampled, sorted.
    const std::vector<double> &times() const { return events; }
    /// Record what is due at the end of this step. Every process must call it.
    void observe(const Step &);
    /// Record every probe that samples single instants once more, whatever the time: the last good
    /// state of a run that ends early. Every process must call it.
    void observe_last(const Step &);

    /// Where and when the mesh first folded at a node, as text; empty if it did not.
    std::string first_folding() const;
    const Folding &folding() const { return folds; }
    /// What was known of folding when the run that goes on here stopped.
    void resume(const Folding &known) { folds = known; }
    /// Why the last observed state is none: pieces of the body in each other; empty: they are not.
    std::string overlap() const;
    /// Where the body lies in itself at the end of this step, as text; empty if it does not.
    std::string self_overlap(const State &) const;
    double smallest_nodal_jacobian() const { return smallest_nodal; }
    int folded_cells_at_end() const { return folded_now; }
    /// Time spent observing.
    const record::Profile::Part &cost() const { return output; }

  private:
    struct ScheduledProbe
    {
      const scene::Probe *probe;
      std::vector<double> times;
      bool every_step = false; // whenever an equilibrium is found, and no step is made for it
    };
    bool due(const ScheduledProbe &, double time) const;
    Snapshot snapshot_of(const Step &) const;
    void monitor_folding(const Step &);
    void observe_probe(const scene::Probe &, const Snapshot &, const State &);
    void reaction_row(const std::string &name, const std::string &support, const State &);
    void history_row(const std::string &name, const Step &);

    const scene::Scene &scene;
    const Problem &problem;
    record::Writer *writer;
    std::vector<scene::Probe> own; // reactions that no probe asks for
    std::vector<ScheduledProbe> scheduled_probes;
    std::vector<double> events;
    double tolerance, default_bin;
    bool energy_asked = false; // by a probe, at its own times
    bool several_pieces = false;
    std::optional<Point> overlapping; // where, in the last observed state
    double overlap_time = 0.;
    Folding folds;
    double smallest_nodal = 1.;
    int folded_now = 0;
    record::Profile::Part output{"output"};
  };
} // namespace fe
