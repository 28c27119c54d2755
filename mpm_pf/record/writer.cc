#include "record/writer.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>

#include "record/cannot_write.h"
#include "record/checkpoint.h"
#include "record/lock.h"
#include "record/write_buffer.h"
#include "record/xdmf.h"
#include "scene/value.h"

namespace record
{
  namespace
  {
    constexpr auto format = "mpm_pf record 1";

    void require_name(const std::string &name)
    {
      if (name.empty() || name.find('/') != std::string::npos || name == ".")
        throw std::invalid_argument("\"" + name +
                                    "\" cannot name something recorded: it is empty "
                                    "or holds '/'");
    }

    void write_head(const hid_t file, const Provenance &provenance, const scene::Scene &scene)
    {
      const auto program = provenance.find("program");
      hdf5::set_attribute(file, "format", std::string(format));
      hdf5::set_attribute(file, "program",
                          program == provenance.end() ? std::string() : program->second);
      hdf5::set_attribute(file, "status", std::string("running"));
      hdf5::set_attribute(file, "title", scene.title);
      hdf5::set_attribute(file, "scene_file", scene.file);
      hdf5::set_attribute(file, "scene_hash", scene.hash);
      const hdf5::Handle group = hdf5::open_group(file, "provenance", true);
      for (const auto &[name, value] : provenance)
        hdf5::set_attribute(group, name, value);
      hdf5::write_text(group, "scene", scene.text);
    }

    void write_profile(const hid_t file, const Profile &profile)
    {
      if (hdf5::exists(file, "profile"))
        hdf5::remove(file, "profile");
      const hdf5::Handle group = hdf5::open_group(file, "profile", true);
      std::vector<std::string> names;
      std::vector<double> wall, cpu, calls;
      for (const Profile::Part &part : profile.parts)
      {
        names.push_back(part.name);
        wall.push_back(part.wall_s);
        cpu.push_back(part.cpu_s);
        calls.push_back(double(part.calls));
      }
      hdf5::write_texts(group, "part", names);
      hdf5::write(group, "wall_s", wall);
      hdf5::write(group, "cpu_s", cpu);
      hdf5::write(group, "calls", calls);
      for (const auto &[name, value] : profile.numbers)
        hdf5::set_attribute(group, name, value);
    }

    void check_snapshot(const std::string &name, const Snapshot &snapshot)
    {
      const bool grid = snapshot.kind == Snapshot::Kind::grid;
      const bool cells = snapshot.kind == Snapshot::Kind::cells;
      if (cells && snapshot.connectivity.size() % 4 != 0)
        throw std::invalid_argument("snapshot " + name + ": cells must have four vertices each");
      const std::size_t size = grid    ? std::size_t(snapshot.nodes[0]) * snapshot.nodes[1]
                               : cells ? snapshot.connectivity.size() / 4
                                       : snapshot.vertex.size();
      for (const auto &[field, values] : snapshot.fields)
        if (values.size() != size)
          throw std::invalid_argument("snapshot " + name + ": field " + field + " has " +
                                      std::to_string(values.size()) + " values, its mesh " +
                                      std::to_string(size));
    }
  } // namespace

  struct Writer::File
  {
    std::string path, part;
    std::optional<Lock>
        lock; // until the record is finished: it alone makes, changes, renames .part
    WriteBuffer buffer;
    bool finished = false;
    bool broken = false; // a write has failed; HDF5 still holds the file and cannot open it again

    explicit File(const std::string &path) : path(path), part(path + ".part") {}

    void take()
    {
      lock.emplace(path + ".lock", path,
                   "wait for its end or stop it, or choose another --output or --record");
    }

    WriteBuffer &open_for(const std::string &name)
    {
      require_name(name);
      if (finished)
        throw std::logic_error(path + " is finished: nothing can be recorded in it any more");
      return buffer;
    }

    void write(hdf5::Handle open, const std::function<void(hid_t file)> &work)
    {
      broken = true;
      hdf5::write_file(std::move(open), part, work);
      broken = false;
    }
    void write(const std::function<void(hid_t file)> &work) { write(reopened(), work); }

  private:
    /// What is there once the run is under way can be opened, unless somebody has taken it away.
    hdf5::Handle reopened() const
    {
      try
      {
        return hdf5::open_file(part, hdf5::Mode::modify);
      }
      catch (const std::runtime_error &error)
      {
        throw CannotWrite(error.what());
      }
    }
  };

  Writer::Writer(const std::string &path, const Provenance &provenance, const scene::Scene &scene,
                 const bool force)
      : file(std::make_unique<File>(path))
  {
    const auto folder = std::filesystem::path(path).parent_path();
    std::error_code failure;
    if (!folder.empty())
      std::filesystem::create_directories(folder, failure);
    if (failure)
      throw std::runtime_error("cannot make the folder " + folder.string() + ": " +
                               failure.message());
    file->take();
    if (std::filesystem::exists(path) && !force)
      throw std::runtime_error(path + " exists: remove it, choose another --output, or give "
                                      "--force to replace it");
    std::filesystem::remove(checkpoint_path(path)); // before: a kill between must not leave both
    file->write(hdf5::open_file(file->part, hdf5::Mode::create),
                [&](const hid_t open) { write_head(open, provenance, scene); });
  }

  Writer::Writer(const std::string &path, const Provenance &provenance, const scene::Scene &scene,
                 const Resume resume)
      : file(std::make_unique<File>(path))
  {
    if (!std::filesystem::exists(file->part))
      throw std::runtime_error("no record " + file->part +
                               " to go on with: start without --resume");
    file->take();
    hdf5::Handle open = hdf5::open_to_resume(file->part, hdf5::Mode::modify);
    if (hdf5::text_attribute(open, "format") != format)
      throw std::runtime_error(file->part +
                               " is not a record of this program: start without --resume");
    if (hdf5::text_attribute(open, "scene_hash") != scene.hash)
      throw std::runtime_error(file->part + " was made from another scene than " + scene.file +
                               ": start without --resume");
    const auto start = provenance.find("start");
    const std::string resumed = "at t = " + scene::number_text(resume.time) + ", " +
                                (start == provenance.end() ? std::string() : start->second) + "; ";
    file->write(std::move(open),
                [&](const hid_t part)
                {
                  file->buffer.resume(part, resume.time);
                  const hdf5::Handle group = hdf5::open_group(part, "provenance");
                  hdf5::set_attribute(group, "resumed",
                                      hdf5::text_attribute(group, "resumed") + resumed);
                });
  }

  Writer::~Writer()
  {
    try
    {
      if (!file->finished && !file->broken)
        flush();
    }
    catch (...)
    {
      // On the way out after another error: what could not be written is lost, as after a kill.
    }
  }

  void Writer::table(const std::string &name, const Columns &columns, const double time,
                     const std::vector<double> &row)
  {
    if (file->open_for(name).add_row(name, columns, time, row))
      flush();
  }

  void Writer::line(const std::string &name, const Columns &columns, const double time,
                    const LineSample &sample)
  {
    if (file->open_for(name).add_line(name, columns, time, sample))
      flush();
  }

  void Writer::outline(const std::string &name, const double time,
                       const std::vector<Polyline> &curves)
  {
    if (file->open_for(name).add_outline(name, time, curves))
      flush();
  }

  void Writer::snapshot(const std::string &name, const double time, const Snapshot &snapshot)
  {
    check_snapshot(name, snapshot);
    WriteBuffer &buffer = file->open_for(name);
    file->write(
        [&](const hid_t open)
        {
          buffer.write(open);
          buffer.write_snapshot(open, name, time, snapshot);
        });
  }

  void Writer::attribute(const std::string &name, const std::string &value)
  {
    file->open_for(name).texts[name] = value;
  }
  void Writer::attribute(const std::string &name, const double value)
  {
    file->open_for(name).numbers[name] = value;
  }

  void Writer::flush()
  {
    file->write([&](const hid_t open) { file->buffer.write(open); });
  }

  void Writer::flush_after(const double seconds)
  {
    if (file->buffer.wait() > seconds)
      flush();
  }

  void Writer::finish(const Profile &profile, const std::string &status)
  {
    file->finished = true;
    const std::string xdmf = std::filesystem::path(file->path).replace_extension(".xdmf").string();
    const std::string name = std::filesystem::path(file->path).filename().string();
    bool drawn = false;
    file->write(
        [&](const hid_t open)
        {
          file->buffer.write(open);
          write_profile(open, profile);
          hdf5::set_attribute(open, "status", status);
          drawn = !hdf5::members(open, "snapshots").empty();
          if (drawn)
            write_xdmf(open, name, xdmf + ".part");
        });
    std::filesystem::rename(file->part, file->path);
    if (drawn)
      std::filesystem::rename(xdmf + ".part", xdmf);
    else
      std::filesystem::remove(xdmf); // that of an earlier record of this name
    file->lock.reset();
  }
} // namespace record
