// Hashes by which finished runs are recognised, and the quoting of commands.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "jobs.h"
#include "record/command_line.h"

namespace verify
{
  namespace
  {
    std::string content(const std::string &path)
    {
      std::ifstream stream(path, std::ios::binary);
      std::stringstream text;
      text << stream.rdbuf();
      return text.str();
    }
  } // namespace

  std::string hash_of(const std::string &text)
  {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char c : text)
      hash = (hash ^ c) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
  }

  std::string hash_of_file(const std::string &path)
  {
    static std::map<std::string, std::string>
        known; // programs are large and asked for by every run
    auto &hash = known[path];
    if (hash.empty())
      hash = std::filesystem::exists(path) ? hash_of(content(path)) : "absent";
    return hash;
  }

  namespace
  {
    void gather(const std::filesystem::path &, std::set<std::filesystem::path> &, std::string &);

    /// Every file that the text names in quotes, beside `folder`.
    void gather_named(const std::string &text, const std::filesystem::path &folder,
                      std::set<std::filesystem::path> &seen, std::string &all)
    {
      static const std::regex quoted(R"re("([^"\n]+)"|'([^'\n]+)')re");
      for (std::sregex_iterator i(text.begin(), text.end(), quoted), end; i != end; ++i)
      {
        const std::string name = (*i)[1].matched ? (*i)[1].str() : (*i)[2].str();
        std::error_code ignored; // a title is no file name and may be too long for one
        const auto file = (folder / name).lexically_normal();
        if (std::filesystem::is_regular_file(file, ignored))
          gather(file, seen, all);
      }
    }

    /// The text of the scene and of every file that it names in quotes (includes, outlines,
    /// records), each once.
    void gather(const std::filesystem::path &path, std::set<std::filesystem::path> &seen,
                std::string &all)
    {
      if (!seen.insert(path).second)
        return;
      const std::string text = content(path);
      all += text;
      if (path.extension() == ".toml")
        gather_named(text, path.parent_path(), seen, all);
    }
  } // namespace

  std::string hash_of_scene(const std::string &path, const std::vector<std::string> &set)
  {
    const auto scene = std::filesystem::path(path).lexically_normal();
    std::set<std::filesystem::path> seen;
    std::string all;
    gather(scene, seen, all);
    for (const std::string &text : set)
      gather_named(text, scene.parent_path(), seen, all);
    return hash_of(all);
  }

  std::string shell(const std::vector<std::string> &arguments)
  {
    return record::shell_quoted(arguments);
  }
} // namespace verify
