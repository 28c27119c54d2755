// Elapsed time, and the parts of a profile that it is added to.
#pragma once

#include <map>
#include <string>

#include "record/provenance.h"
#include "record/writer.h"

namespace record
{
  /// Seconds since it was made: wall clock, and CPU of the whole process.
  class Stopwatch
  {
  public:
    double wall_seconds() const { return record::wall_seconds() - wall; }
    double cpu_seconds() const { return record::cpu_seconds() - cpu; }
    /// Adds them, and one call, to a part of a profile.
    void add_to(Profile::Part &part) const
    {
      part.wall_s += wall_seconds();
      part.cpu_s += cpu_seconds();
      ++part.calls;
    }

  private:
    double wall = record::wall_seconds(), cpu = record::cpu_seconds();
  };

  /// Adds the time from its construction to its end, and one call, to a part of a profile.
  class PartTimer
  {
  public:
    /// `part` must outlive the timer.
    explicit PartTimer(Profile::Part &part) : part(part) {}
    ~PartTimer() { stopwatch.add_to(part); }
    PartTimer(const PartTimer &) = delete;
    PartTimer &operator=(const PartTimer &) = delete;

  private:
    Profile::Part &part;
    Stopwatch stopwatch;
  };

  /// A timer of the part `name` among `parts`, which gets it if it is not there.
  inline PartTimer time_part(std::map<std::string, Profile::Part> &parts, const std::string &name)
  {
    Profile::Part &part = parts[name];
    part.name = name;
    return PartTimer(part);
  }
} // namespace record
