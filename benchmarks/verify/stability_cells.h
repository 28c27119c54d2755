// The cells of a stability map: each is one run, and its class is read from how it ended and what
// its record holds.
#pragma once

#include <string>
#include <vector>

#include "campaign.h"
#include "stability_file.h"

namespace verify
{
  struct Cell
  {
    const Map *map = nullptr; // never null once made
    std::size_t column = 0, row = 0;
    std::string x, y, name, kind, why;
    Job job;
    Outcome outcome;
    bool stable() const { return kind == "accurate" || kind == "bounded but wrong"; }
    /// What ran out of time, was refused or not judged is neither stable nor unstable.
    bool unstable() const { return kind == "diverged" || kind == "growing energy"; }
    bool judged() const { return stable() || unstable(); }
  };

  /// "[0.1, 2]" -> "0.1", "2"; nothing of a value that is no list.
  std::vector<std::string> entries_of(const std::string &value);

  /// A setting of an axis at a value: "{value}" becomes the value (nothing, if that is `absent`),
  /// of a list "{0}", "{1}", ... become its entries.
  std::string with_value(std::string setting, const std::string &value);

  /// Makes, runs and classifies cells. Classes: accurate, bounded but wrong, growing energy,
  /// diverged, out of time, refused, not judged (its record lacks what the classes are read from).
  struct Mapper
  {
    const Stability &stability;
    const Paths &paths;
    const CampaignOptions &options;
    std::string runs; // folder of the runs of all maps

    /// The cell at values x and y of map `number`, not yet run.
    Cell cell(const Map &, std::size_t number, const std::string &x, const std::string &y) const;
    /// All cells of a map, row by row.
    std::vector<Cell> grid(const Map &, std::size_t number) const;
    /// Runs them side by side and classifies them.
    void run(std::vector<Cell> &) const;

    void classify(Cell &) const;
    void classify_finished(Cell &) const;
    bool energy_grows(Cell &, Records &) const;
  };
} // namespace verify
