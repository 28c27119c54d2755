#include "places.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include "jobs.h"
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

  Places find_places(const std::string &argv0, const std::string &cases, const std::string &solvers)
  {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    std::string root = root_above(fs::current_path());
    if (root.empty())
      root = root_above(program.parent_path());
    Places places;
    places.program = argv0;
    if (!cases.empty())
      places.asked.insert(places.asked.end(), {"--cases", cases});
    if (!solvers.empty())
      places.asked.insert(places.asked.end(), {"--solvers", solvers});
    places.solvers = shortened(solvers.empty() ? program.parent_path() : fs::absolute(solvers));
    places.postprocess = root.empty() ? "postprocess" : shortened(fs::path(root) / "postprocess");
    places.cases = cases.empty() ? shortened(fs::path(root) / "benchmarks") : cases;
    if ((cases.empty() && root.empty()) || !fs::is_directory(places.cases))
      throw BadInput("no folder of cases: start verify inside the project, or give --cases DIR");
    if (!fs::is_directory(places.solvers))
      throw BadInput(fmt::format("--solvers {}: there is no such folder; give the one that holds "
                                 "mpm_pf and fe_reference",
                                 solvers));
    return places;
  }

  std::vector<std::string> case_names(const Places &places)
  {
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(places.cases))
      if (entry.is_directory() && fs::exists(entry.path() / "expect.toml"))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::string case_folder(const Places &places, const std::string &name)
  {
    const auto names = case_names(places);
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw BadInput(fmt::format("there is no case `{}` in {}; there are: {}", name, places.cases,
                                 fmt::join(names, ", ")));
    return (fs::path(places.cases) / name).string();
  }

  int run_python(const Places &places, const std::string &script,
                 const std::vector<std::string> &arguments)
  {
    // Debian's own, because another python3 may stand first on PATH without the modules
    const std::string python = fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
    const std::string file = places.postprocess + "/" + script;
    if (!fs::exists(file))
    {
      fmt::print(stderr, "{} is missing: nothing is drawn\n", file);
      return 2;
    }
    std::vector<std::string> words{python, "-B", file};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const int status = std::system((shell(words) + " </dev/null").c_str());
    if (status == -1)
      return 2;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
} // namespace verify
