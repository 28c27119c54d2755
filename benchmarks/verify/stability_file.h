// stability.toml: over which axes a case is driven to its limits, and what counts as accurate
// (README.md defines the format).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "expect.h"

namespace verify
{
  /// One axis of a map: the settings of each value. "{value}" in a setting stands for the value; of
  /// the value `absent` nothing stands there, which takes the key away.
  struct Axis
  {
    std::string label;
    std::vector<std::string> values; // as TOML text
    std::vector<std::string> set;    // "key={value}"
    bool logarithmic = false;        // where bisection meets: geometric mean
    std::optional<double> absent;    // what `absent` counts as in expressions
  };

  /// Name of the value that takes a key away.
  extern const std::string absent_value;

  /// What tells growing energy: max |of| over the last half of the run against `limit`, or `growth`
  /// times the first half.
  struct EnergyWatch
  {
    Take take;
    double growth = 10.;
    std::optional<double> limit;
  };

  struct Map
  {
    std::string name, solver, scene;
    std::vector<std::string> set;
    Axis x, y;
    int bisections = 0;
    /// The theoretical limit on x, an expression of y: of the rows with this word for y; under ""
    /// of all others.
    std::map<std::string, std::string> theory;
    std::optional<std::array<double, 2>> edge; // what edge over theory must lie between
    double time_limit_s = 60.;

    /// Values of y, "" where there is no such axis.
    std::vector<std::string> rows() const;
  };

  /// What must hold for "accurate", in the maps named (none: in all). Its expressions know axis_x
  /// and axis_y, the values of the cell where these are numbers, and axis_x0, axis_x1, ..., the
  /// entries of a value that is a list.
  struct Accurate
  {
    Check check; // take and against a run named "cell"
    std::vector<std::string> maps;
  };

  struct Stability
  {
    Case c;
    std::vector<Accurate> accurate;
    std::optional<EnergyWatch> energy;
    std::vector<Map> maps;
  };

  /// Reads <folder>/stability.toml for a suite (values may differ by suite). Throws BadInput with
  /// every error.
  Stability read_stability(const std::string &folder, const std::string &suite);
} // namespace verify
