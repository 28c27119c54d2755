// Hashes by which finished runs are recognised, and the quoting of commands.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
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

  std::string hash_of_scene(const std::string &path)
  {
    const std::string text = content(path);
    std::string all = text;
    const std::regex include(R"(^\s*include\s*=\s*["']([^"']+)["'])", std::regex::multiline);
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i)
      all += hash_of_scene((std::filesystem::path(path).parent_path() / (*i)[1].str()).string());
    return hash_of(all);
  }

  std::string shell(const std::vector<std::string> &arguments)
  {
    return record::shell_quoted(arguments);
  }
} // namespace verify
