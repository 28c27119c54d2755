// Where things are: the cases, the solvers, the Python that draws.
#pragma once

#include <string>
#include <vector>

namespace verify
{
  struct Paths
  {
    std::string cases;       // folder of the case folders
    std::string solvers;     // folder of mpm_pf and fe_reference
    std::string postprocess; // folder of report.py and figures.py
    std::string program;     // this program, as to be typed

    /// --cases and --solvers as they were given, for a command that repeats something.
    std::vector<std::string> asked;

    std::string solver(const std::string &name) const { return solvers + "/" + name; }
  };

  /// `cases` and `solvers` may be empty: then benchmarks/ is looked for upwards from the working
  /// directory and from the program, and the solvers beside the program. Throws BadInput if there
  /// is no case folder.
  Paths find_paths(const std::string &argv0, const std::string &cases, const std::string &solvers);

  /// Names of all cases (folders with an expect.toml), sorted.
  std::vector<std::string> case_names(const Paths &);
  /// Those that were named, each once in the order of its first mention; all if none was.
  std::vector<std::string> chosen_cases(const std::vector<std::string> &named, const Paths &);
  /// Folder of one case. Throws BadInput with the nearest names if there is none.
  std::string case_folder(const Paths &, const std::string &name);

  /// Runs Debian's Python on a script of postprocess/ with `arguments`, output to ours. Returns its
  /// exit code; says on stderr what is missing if Python or a module is.
  int run_python(const Paths &, const std::string &script,
                 const std::vector<std::string> &arguments);
} // namespace verify
