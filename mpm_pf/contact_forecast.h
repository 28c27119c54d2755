// What a run will cost in all, estimated once more when a wall has met its crystal: how large the
// crystal is and what a step with points takes is known by then, not guessed as for --plan.
#pragma once

#include <optional>

#include "world.h"

/// Where a run stands after one of its coupling steps.
struct RunProgress
{
  double time = 0., end = 0.; // end: when it is now thought to be over; times of the scene
  long steps = 0;             // coupling steps
  double cpu_s = 0.;          // spent on the run so far, earlier starts included
};

/// From the first steps after contact: the pace of these, carried on to the end.
class ContactForecast
{
public:
  /// A step that points have taken part in, pressed by a wall. The first one is the contact.
  void add(const RunProgress &);

  /// CPU seconds of the whole run as estimated then; empty before a fiftieth of the way from
  /// contact to end, ten steps and a tenth of a second were done.
  const std::optional<double> &cpu_s() const { return forecast; }

  /// The run goes on from a checkpoint; empty: there was no estimate yet.
  void restore(const std::optional<double> &cpu_s) { forecast = cpu_s; }

private:
  std::optional<RunProgress> contact;
  std::optional<double> forecast;
};

/// Adds where a world stands that has spent so many seconds of CPU, if walls press on what grows.
void add(ContactForecast &, const World &, double cpu_s);
