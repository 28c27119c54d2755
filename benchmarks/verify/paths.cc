#include "paths.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include "jobs.h"
#include "record/command_line.h"
#include "section.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    /// The nearest folder at or above `from` that holds benchmarks/verify, or "".
    std::string root_above(fs::path from)
    {
      for (; !from.empty(); from = from.parent_path())
      {
        if (fs::exists(from / "benchmarks" / "verify" / "README.md"))
          return from.string();
        if (from == from.root_path())
          break;
      }
      return "";
    }

    std::string shortened(const fs::path &path)
    {
      const fs::path relative = fs::relative(path, fs::current_path());
      return relative.string().size() < path.string().size() ? relative.string() : path.string();
    }
  } // namespace

  Paths find_paths(const std::string &argv0, const std::string &cases, const std::string &solvers)
  {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    std::string root = root_above(fs::current_path());
    if (root.empty())
      root = root_above(program.parent_path());
    Paths paths;
    paths.program = argv0;
    if (!cases.empty())
      paths.asked.insert(paths.asked.end(), {"--cases", cases});
    if (!solvers.empty())
      paths.asked.insert(paths.asked.end(), {"--solvers", solvers});
    paths.solvers = shortened(solvers.empty() ? program.parent_path() : fs::absolute(solvers));
    paths.postprocess = root.empty() ? "postprocess" : shortened(fs::path(root) / "postprocess");
    paths.cases = cases.empty() ? shortened(fs::path(root) / "benchmarks") : cases;
    if ((cases.empty() && root.empty()) || !fs::is_directory(paths.cases))
      throw BadInput("no folder of cases: start verify inside the project, or give --cases DIR");
    if (!fs::is_directory(paths.solvers))
      throw BadInput(fmt::format("--solvers {}: there is no such folder; give the one that holds "
                                 "mpm_pf and fe_reference",
                                 solvers));
    return paths;
  }

  std::vector<std::string> case_names(const Paths &paths)
  {
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(paths.cases))
      if (entry.is_directory() && fs::exists(entry.path() / "expect.toml"))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::vector<std::string> chosen_cases(const std::vector<std::string> &named, const Paths &paths)
  {
    std::vector<std::string> chosen;
    for (const auto &name : named)
      if (std::find(chosen.begin(), chosen.end(), name) == chosen.end())
        chosen.push_back(name);
    return named.empty() ? case_names(paths) : chosen;
  }

  std::string case_folder(const Paths &paths, const std::string &name)
  {
    const auto names = case_names(paths);
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw BadInput(fmt::format("there is no case `{}` in {}; there are: {}", name, paths.cases,
                                 fmt::join(names, ", ")));
    return (fs::path(paths.cases) / name).string();
  }

  int run_python(const Paths &paths, const std::string &script,
                 const std::vector<std::string> &arguments)
  {
    // Debian's own, because another python3 may stand first on PATH without the modules
    const std::string python = fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
    const std::string file = paths.postprocess + "/" + script;
    if (!fs::exists(file))
    {
      fmt::print(stderr, "{} is missing: nothing is drawn\n", file);
      return record::bad_input;
    }
    std::vector<std::string> words{python, "-B", file};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const int status = std::system((shell(words) + " </dev/null").c_str());
    if (status == -1)
      return record::bad_input;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
} // namespace verify
