#include "record_mark.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <sys/stat.h>

#include "record/outline_source.h"
#include "record/reader.h"
#include "scene/reader.h"

namespace verify
{
  std::optional<RecordMark> mark_record(const std::string &path)
  {
    struct stat file
    {
    };
    if (stat(path.c_str(), &file) != 0)
      return {};
    try
    {
      RecordMark mark;
      mark.scene_hash = record::Reader(path).attribute("scene_hash");
      mark.bytes = static_cast<std::uintmax_t>(file.st_size);
      mark.modified_ns =
          std::int64_t(file.st_mtim.tv_sec) * 1000000000 + std::int64_t(file.st_mtim.tv_nsec);
      return mark;
    }
    catch (const std::runtime_error &)
    {
      return {};
    }
  }

  Json to_json(const RecordMark &mark)
  {
    return {
        {"scene_hash", mark.scene_hash}, {"bytes", mark.bytes}, {"modified_ns", mark.modified_ns}};
  }

  std::optional<RecordMark> mark_in(const Json &state)
  {
    const Json record = state.is_object() ? state.value("record", Json()) : Json();
    if (!record.is_object())
      return {};
    return RecordMark{record.value("scene_hash", ""), record.value("bytes", std::uintmax_t(0)),
                      record.value("modified_ns", std::int64_t(0))};
  }

  Json state_beside(const std::string &base)
  {
    std::ifstream stream(base + ".run.json");
    return stream ? Json::parse(stream, nullptr, false) : Json();
  }

  std::string replaced_record(const std::string &base)
  {
    const auto left = mark_in(state_beside(base));
    const auto now = mark_record(base + ".h5");
    if (!left || !now || *now == *left)
      return "";
    const bool foreign = now->scene_hash != left->scene_hash;
    return fmt::format("{}.h5 {} the one that the run left{}; the next `verify run` repeats it",
                       base, foreign ? "is of another scene than" : "is not",
                       foreign ? "" : ": it was written or copied over since");
  }

  std::string other_scene(const RecordMark &mark, const Job &job)
  {
    try
    {
      scene::Scene scene = scene::read_scene(job.scene, job.set);
      record::resolve_outlines(scene);
      if (mark.scene_hash != scene.hash)
        return fmt::format("its record was made from another scene than {} as it is now: was that "
                           "changed while it ran, or is the solver of another version?\n",
                           job.scene);
    }
    catch (const std::exception &) // the solver has said what is wrong
    {
    }
    return "";
  }
} // namespace verify
