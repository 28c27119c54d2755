#include "record/reader.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "record/hdf5_file.h"

namespace record
{
  namespace
  {
    hdf5::Handle open_record(const std::string &path)
    {
      if (!std::filesystem::exists(path))
        throw std::runtime_error(
            path +
            (std::filesystem::exists(path + ".part")
                 ? " is unfinished: its run was interrupted or still goes on (" + path + ".part)"
                 : " does not exist"));
      hdf5::Handle file = hdf5::open_file(path, hdf5::Mode::read);
      if (hdf5::text_attribute(file, "format").rfind("mpm_pf record", 0) != 0)
        throw std::runtime_error(path + " is an HDF5 file, but not a record of this program");
      return file;
    }

    std::vector<Point> points(const std::vector<double> &flat)
    {
      std::vector<Point> list(flat.size() / 2);
      for (std::size_t k = 0; k < list.size(); ++k)
        list[k] = Point(flat[2 * k], flat[2 * k + 1]);
      return list;
    }

    /// Row `k` of `width` values.
    std::vector<double> row(const std::vector<double> &values, const std::size_t k,
                            const std::size_t width)
    {
      return {values.begin() + long(k * width), values.begin() + long((k + 1) * width)};
    }

    Columns columns(const hid_t group)
    {
      return {hdf5::texts_attribute(group, "columns"), hdf5::texts_attribute(group, "units")};
    }

    Point pair(const hid_t group, const std::string &name)
    {
      const std::vector<double> values = hdf5::numbers_attribute(group, name);
      return {values.at(0), values.at(1)};
    }
  } // namespace

  struct Reader::File
  {
    std::string path;
    hdf5::Handle handle;

    /// The group of `name` in `folder`, or an error that lists what is there.
    hdf5::Handle find(const std::string &folder, const std::string &name) const
    {
      const std::string group = folder + "/" + name;
      if (!name.empty() && hdf5::exists(handle, group))
        return hdf5::open_group(handle, group);
      std::string present;
      for (const std::string &other : hdf5::members(handle, folder))
        present += (present.empty() ? "" : ", ") + other;
      throw std::runtime_error(path + ": " + folder + " holds no \"" + name + "\", only " +
                               (present.empty() ? "nothing" : present));
    }
  };

  Reader::Reader(const std::string &path)
      : file(std::make_unique<File>(File{path, open_record(path)}))
  {
  }
  Reader::~Reader() = default;

  std::string Reader::status() const
  {
    return attribute("status");
  }

  std::string Reader::attribute(const std::string &name) const
  {
    if (hdf5::has_attribute(file->handle, name))
      return hdf5::text_attribute(file->handle, name);
    return hdf5::text_attribute(hdf5::open_group(file->handle, "provenance"), name);
  }

  double Reader::number(const std::string &name) const
  {
    if (hdf5::has_attribute(file->handle, name) || !hdf5::exists(file->handle, "profile"))
      return hdf5::number_attribute(file->handle, name);
    return hdf5::number_attribute(hdf5::open_group(file->handle, "profile"), name);
  }

  Provenance Reader::provenance() const
  {
    const hdf5::Handle group = hdf5::open_group(file->handle, "provenance");
    Provenance all;
    for (const std::string &name : hdf5::attributes(group))
      all[name] = hdf5::text_attribute(group, name);
    return all;
  }

  std::string Reader::scene_text() const
  {
    return hdf5::read_text(file->handle, "provenance/scene");
  }

  std::vector<std::string> Reader::tables() const
  {
    return hdf5::members(file->handle, "tables");
  }
  std::vector<std::string> Reader::lines() const
  {
    return hdf5::members(file->handle, "lines");
  }
  std::vector<std::string> Reader::outlines() const
  {
    return hdf5::members(file->handle, "outlines");
  }
  std::vector<std::string> Reader::snapshots() const
  {
    return hdf5::members(file->handle, "snapshots");
  }

  Table Reader::table(const std::string &name) const
  {
    const hdf5::Handle group = file->find("tables", name);
    Table table{columns(group), hdf5::read<double>(group, "time"), {}};
    const auto values = hdf5::read<double>(group, "values");
    for (std::size_t k = 0; k < table.time.size(); ++k)
      table.rows.push_back(row(values, k, table.columns.names.size()));
    return table;
  }

  Lines Reader::line(const std::string &name) const
  {
    const hdf5::Handle group = file->find("lines", name);
    Lines lines{columns(group), hdf5::read<double>(group, "time"), {}};
    hdf5::Shape shape;
    const auto position = hdf5::read<double>(group, "position", &shape);
    const auto values = hdf5::read<double>(group, "values");
    const std::size_t m = shape.at(1);
    for (std::size_t k = 0; k < lines.time.size(); ++k)
      lines.samples.push_back(
          {points(row(position, k, 2 * m)), row(values, k, m * lines.columns.names.size())});
    return lines;
  }

  Outlines Reader::outline(const std::string &name) const
  {
    file->find("outlines", name);
    Outlines outlines;
    for (const std::string &path : hdf5::numbered(file->handle, "outlines/" + name))
    {
      const hdf5::Handle group = hdf5::open_group(file->handle, path);
      const auto offset = hdf5::read<int>(group, "offset");
      const auto vertex = points(hdf5::read<double>(group, "vertex"));
      std::vector<Polyline> curves;
      for (std::size_t j = 0; j + 1 < offset.size(); ++j)
        curves.emplace_back(vertex.begin() + offset[j], vertex.begin() + offset[j + 1]);
      outlines.time.push_back(hdf5::number_attribute(group, "time"));
      outlines.outlines.push_back(std::move(curves));
    }
    return outlines;
  }

  std::vector<double> Reader::snapshot_times(const std::string &name) const
  {
    file->find("snapshots", name);
    std::vector<double> times;
    for (const std::string &path : hdf5::numbered(file->handle, "snapshots/" + name))
      times.push_back(hdf5::number_attribute(hdf5::open_group(file->handle, path), "time"));
    return times;
  }

  Snapshot Reader::snapshot(const std::string &name, const std::size_t index) const
  {
    const hdf5::Handle all = file->find("snapshots", name);
    if (!hdf5::exists(all, std::to_string(index)))
      throw std::runtime_error(
          file->path + ": snapshot \"" + name + "\" was taken only " +
          std::to_string(hdf5::members(file->handle, "snapshots/" + name).size()) + " times");
    const hdf5::Handle group = hdf5::open_group(all, std::to_string(index));
    const std::string kind = hdf5::text_attribute(group, "kind");
    Snapshot snapshot;
    snapshot.kind = kind == "grid"    ? Snapshot::Kind::grid
                    : kind == "cells" ? Snapshot::Kind::cells
                                      : Snapshot::Kind::points;
    if (snapshot.kind == Snapshot::Kind::grid)
    {
      snapshot.origin = pair(group, "origin");
      snapshot.spacing = pair(group, "spacing");
      hdf5::Shape nx, ny;
      hdf5::read<double>(group, "x", &nx);
      hdf5::read<double>(group, "y", &ny);
      snapshot.nodes = {int(nx.at(0)), int(ny.at(0))};
    }
    else
      snapshot.vertex = points(hdf5::read<double>(group, "vertex"));
    if (snapshot.kind == Snapshot::Kind::cells)
      snapshot.connectivity = hdf5::read<int>(group, "connectivity");
    for (const std::string &field : hdf5::members(group, "fields"))
      snapshot.fields[field] = hdf5::read<double>(group, "fields/" + field);
    return snapshot;
  }

  Profile Reader::profile() const
  {
    Profile profile;
    if (!hdf5::exists(file->handle, "profile"))
      return profile;
    const hdf5::Handle group = hdf5::open_group(file->handle, "profile");
    const auto names = hdf5::read_texts(group, "part");
    const auto wall = hdf5::read<double>(group, "wall_s"), cpu = hdf5::read<double>(group, "cpu_s");
    const auto calls = hdf5::read<double>(group, "calls");
    for (std::size_t k = 0; k < names.size(); ++k)
      profile.parts.push_back({names[k], wall.at(k), cpu.at(k), std::lround(calls.at(k))});
    for (const std::string &name : hdf5::attributes(group))
      profile.numbers[name] = hdf5::number_attribute(group, name);
    return profile;
  }
} // namespace record
