// What a case runs and what must come out: expect.toml as plain data (README.md here defines the
// format).
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "formula.h"

namespace verify
{
  /// One process to run. Names are unique within case and suite.
  struct Run
  {
    std::string name, solver, scene; // scene: file name in the case folder
    std::vector<std::string> set;    // "key=value"
    std::vector<std::string>
        needs;               // runs that must be finished first; "{name}" in `set` is their record
    std::optional<double> h; // mesh size, in the scene's length unit
    int threads = 1, processes = 1;
    double time_limit_s = 0.;
    int expect_exit = 0;
    std::string expect_output; // regular expression that the log must contain
  };

  /// What is measured: one probe of one run.
  struct Take
  {
    enum class Kind
    {
      table,
      line,
      outline,
      snapshot,
      number,
      value
    } kind = Kind::table;
    std::string run;
    std::vector<std::array<std::string, 2>> probes; // prefix ("" for one table) and name
    std::string of, abscissa, reduce;
    std::string at;                   // expression, "end", or "" (a whole history)
    std::string nth;                  // which recording of a line, outline or snapshot, from 1
    std::vector<std::string> between; // none or two expressions
    bool along_abscissa = false;      // `between` is of the abscissa, not of time
    std::string side, x, y;           // of an outline's side position, extreme
    std::string mirror; // x, y: image of an outline (first) or raster in the line x = 0, y = 0
    std::string rotate; // degrees by which an outline is turned about the origin, then
    std::vector<std::string> shift; // none or two expressions: what an outline is moved by, last
    std::vector<std::string> box;   // none or four expressions: x0 y0 x1 y1
    std::string bin;                // side of the squares over which a snapshot is averaged
    std::vector<std::string> with_names;
    std::vector<Take> with;
    double coverage = 0.95; // of a line's samples, to be in material where it is reduced
  };

  /// What it is held against.
  struct Against
  {
    enum class Kind
    {
      nothing,
      run,
      formula,
      csv,
      number,
      zero
    } kind = Kind::nothing;
    Take take;        // run; for csv: of, abscissa, at, between, reduce
    std::string text; // formula, file name or number
  };

  struct Check
  {
    std::string name, norm, unit, source, reason, scale;
    Take take;
    Against against;
    double low = 0., high = 0.;
    std::vector<std::string> order_over;
    std::vector<std::string> uncertain_take, uncertain_against;
    double order_at_most = 2.;
    std::optional<double> coverage;
    double drift = 0.02;
  };

  /// Names of the runs that a take is of.
  std::set<std::string> runs_of(const Take &);
  /// Names of the runs that the check judges: not those that it holds them against.
  std::set<std::string> runs_taken_by(const Check &);
  /// Names of all runs that the check takes anything from.
  std::set<std::string> runs_of(const Check &);

  /// A case as it stands in one suite.
  struct Case
  {
    std::string name, folder, title, about, suite, scene;
    Constants constants;
    std::vector<Run> runs;
    std::vector<Check> checks;

    const Run *find_run(const std::string &) const; // null if there is none
  };

  /// Scene file of a suite: smoke.toml, quick.toml, scene.toml.
  std::string scene_file(const std::string &suite);
  /// Folder name of a suite's records: smoke, quick, scene.
  std::string scene_stem(const std::string &suite);

  /// Names of the norms.
  extern const std::array<const char *, 15> norms;

  /// Reads <folder>/expect.toml for one suite. Throws BadInput with every error of the file.
  Case read_case(const std::string &folder, const std::string &suite);
  /// Does the case take part in the suite (has its scene file)?
  bool takes_part(const std::string &folder, const std::string &suite);
} // namespace verify
