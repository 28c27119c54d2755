// What each module has cost: calls and seconds, booked where the module is called, once per
// coupling step. A module that is absent is never called and has no entry.
#pragma once

#include <string>

#include "record/provenance.h"
#include "world.h"

/// Books the time from its construction to its end under the name of a module.
class Stopwatch
{
public:
  Stopwatch(World &world, const std::string &module)
      : part(world.spent[module]), wall(record::wall_seconds()), cpu(record::cpu_seconds())
  {
    part.name = module;
  }
  ~Stopwatch()
  {
    part.wall_s += record::wall_seconds() - wall;
    part.cpu_s += record::cpu_seconds() - cpu;
    ++part.calls;
  }
  Stopwatch(const Stopwatch &) = delete;
  Stopwatch &operator=(const Stopwatch &) = delete;

private:
  record::Profile::Part &part;
  double wall, cpu;
};
