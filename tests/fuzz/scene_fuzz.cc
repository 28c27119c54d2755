// libFuzzer on the scene reader: whatever the bytes, read_scene returns a scene or throws BadScene;
// and a scene that is accepted is read back from its own text with the same hash.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "scene/reader.h"

namespace
{
  // The reader takes files; this one is removed when the process ends.
  struct Folder
  {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("scene_fuzz_" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };

  std::string written(const char *name, const std::string &text)
  {
    static const Folder folder;
    std::ofstream(folder.path / name, std::ios::binary) << text;
    return (folder.path / name).string();
  }
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  // Outline files and includes lead out of the input: what they hold is not ours to fuzz.
  const std::string text(reinterpret_cast<const char *>(data), size);
  if (text.find("include") != std::string::npos || text.find("file") != std::string::npos)
    return 0;
  scene::Scene first;
  try
  {
    first = scene::read_scene(written("first.toml", text));
  }
  catch (const scene::BadScene &)
  {
    return 0;
  }
  if (scene::read_scene(written("second.toml", first.text)).hash != first.hash)
    std::abort();
  return 0;
}
