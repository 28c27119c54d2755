// The force of a support, as a probe reports it: a mean over the sampling interval round each
// sample.
//
// An explicit dynamic solution rings; the force of one step says little. The impulse that a support
// has exerted is exact, so the force at t_k is (impulse(t_k + w) - impulse(t_k - w))/2w with w half
// the sampling interval, centred and hence without lag. At the two ends of the run the window is
// one-sided; there the row is extrapolated linearly from its own centre and its neighbour's.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

/// One row of a reaction table: mean force (N per unit depth) and displacement of the support.
struct ReactionRow
{
  double time = 0.;
  scene::Point force = scene::Point::Zero(), displacement = scene::Point::Zero();
};

/// Samples at `times` (sorted), windows of half width `half_width`, cut off at 0 and `end`. Time.
struct ReactionSampling
{
  std::vector<double> times;
  double half_width = 0., end = 0.;
};

class ReactionWindow
{
public:
  explicit ReactionWindow(const ReactionSampling &);

  /// Every time at which add() must be called: samples and the ends of their windows.
  std::vector<double> events() const;

  /// Add impulse and displacement at one of the events; later events come later. Returns the rows
  /// that are complete now and have not been returned before.
  std::vector<ReactionRow> add(double time, const scene::Point &impulse,
                               const scene::Point &displacement);

  /// The run ends here, at `time`, before its clock: samples that will not come are dropped, the
  /// last moment is one, and windows reach to it. add() must be called for it next.
  void end_early(double time);

  /// For checkpoints: readings and rows still wait for, as flat numbers.
  std::vector<double> state() const;
  void restore(const std::vector<double> &);

private:
  struct Reading
  {
    double time;
    scene::Point impulse, displacement;
  };
  const Reading *reading_at(double time) const;
  double begin_of(std::size_t sample) const; // of its window
  /// Mean force of sample k and the centre of its window; empty until its window has passed.
  struct Mean
  {
    double centre;
    scene::Point force;
  };
  std::optional<Mean> mean(std::size_t sample) const;

  std::vector<double> times;
  double half, end, tolerance;
  std::vector<Reading> readings;
  std::size_t returned = 0;
  bool ended_early = false; // the last sample is an end that was not foreseen
};
