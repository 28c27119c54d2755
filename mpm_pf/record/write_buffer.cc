#include "record/write_buffer.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace record
{
  namespace
  {
    constexpr std::size_t most_waiting_bytes = std::size_t(16) << 20;

    Series &declared(std::map<std::string, Series> &all, const std::string &name,
                     const Columns &columns, const std::size_t positions)
    {
      const auto [entry, is_new] = all.try_emplace(name);
      Series &series = entry->second;
      if (is_new)
      {
        if (columns.names.empty() || columns.names.size() != columns.units.size())
          throw std::invalid_argument(name + ": a record needs columns, each with a unit");
        series.columns = columns;
        series.positions = positions;
      }
      if (series.columns.names != columns.names || series.columns.units != columns.units ||
          series.positions != positions)
        throw std::invalid_argument(name + ": columns, units and number of positions cannot change "
                                           "during a record");
      return series;
    }

    void require_values(const std::string &name, const std::size_t given,
                        const std::size_t expected)
    {
      if (given != expected)
        throw std::invalid_argument(name + ": " + std::to_string(given) + " values given for " +
                                    std::to_string(expected) + " columns and positions");
    }

    std::vector<double> flattened(const std::vector<Point> &points)
    {
      std::vector<double> flat;
      flat.reserve(2 * points.size());
      for (const Point &point : points)
        flat.insert(flat.end(), {point[0], point[1]});
      return flat;
    }

    void append(std::vector<double> &to, const std::vector<double> &from)
    {
      to.insert(to.end(), from.begin(), from.end());
    }

    void write_series(const hid_t file, const std::string &folder, const std::string &name,
                      Series &series)
    {
      const hdf5::Handle group = hdf5::open_group(file, folder + "/" + name, true);
      const hsize_t width = series.columns.names.size();
      if (!series.in_file)
      {
        hdf5::set_attribute(group, "columns", series.columns.names);
        hdf5::set_attribute(group, "units", series.columns.units);
        hdf5::create_rows(group, "time", {});
        if (series.positions > 0)
          hdf5::create_rows(group, "position", {series.positions, 2});
        hdf5::create_rows(group, "values",
                          series.positions > 0 ? hdf5::Shape{series.positions, width}
                                               : hdf5::Shape{width});
        series.in_file = true;
      }
      // The times go last: a row counts only when all of it is there.
      hdf5::append_rows(group, "values", series.values);
      if (series.positions > 0)
        hdf5::append_rows(group, "position", series.position);
      hdf5::append_rows(group, "time", series.time);
      series.time.clear();
      series.position.clear();
      series.values.clear();
    }

    void write_outline(const hid_t file, const std::string &name, const TimedOutline &outline)
    {
      const std::string folder = "outlines/" + name;
      const std::string index = std::to_string(hdf5::members(file, folder).size());
      const hdf5::Handle group = hdf5::open_group(file, folder + "/" + index, true);
      std::vector<int> offset{0};
      std::vector<double> vertex;
      for (const Polyline &curve : outline.curves)
      {
        append(vertex, flattened(curve));
        offset.push_back(int(vertex.size() / 2));
      }
      hdf5::set_attribute(group, "time", outline.time);
      hdf5::write(group, "offset", offset);
      hdf5::write(group, "vertex", vertex, {vertex.size() / 2, 2});
    }

    /// How many of the ascending times are not later than `time`.
    std::size_t count_until(const std::vector<double> &times, const double time)
    {
      return std::size_t(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    }

    /// What is declared in `folder`, cut off after `time`; `kept` gets the last time of each.
    std::map<std::string, Series> take_up(const hid_t file, const std::string &folder,
                                          const double time, std::map<std::string, double> &kept)
    {
      std::map<std::string, Series> all;
      for (const std::string &name : hdf5::members(file, folder))
      {
        const hdf5::Handle group = hdf5::open_group(file, folder + "/" + name);
        Series &series = all[name];
        series.in_file = true;
        series.columns.names = hdf5::texts_attribute(group, "columns");
        series.columns.units = hdf5::texts_attribute(group, "units");
        const auto times = hdf5::read<double>(group, "time");
        const auto rows = count_until(times, time);
        hdf5::truncate_rows(group, "time", rows);
        hdf5::truncate_rows(group, "values", rows);
        if (rows > 0)
          kept[folder + "/" + name] = times[rows - 1];
        if (hdf5::exists(group, "position"))
        {
          hdf5::truncate_rows(group, "position", rows);
          hdf5::Shape shape;
          hdf5::read<double>(group, "position", &shape);
          series.positions = shape.at(1);
        }
      }
      return all;
    }

    void forget_later(const hid_t file, const std::string &folder, const double time,
                      std::map<std::string, double> &kept)
    {
      for (const std::string &name : hdf5::members(file, folder))
        for (const std::string &path : hdf5::numbered(file, folder + "/" + name))
        {
          const double taken = hdf5::number_attribute(hdf5::open_group(file, path), "time");
          if (taken <= time)
            kept[folder + "/" + name] = taken;
          else // later, or not even finished
            hdf5::remove(file, path);
        }
    }
  } // namespace

  bool WriteBuffer::is_due(const std::size_t added_bytes)
  {
    waiting_bytes += added_bytes;
    return waiting_bytes > most_waiting_bytes;
  }

  bool WriteBuffer::is_in_file(const std::string &path, const double time) const
  {
    const auto kept = kept_until.find(path);
    return kept != kept_until.end() && time <= kept->second;
  }

  bool WriteBuffer::add_row(const std::string &name, const Columns &columns, const double time,
                            const std::vector<double> &row)
  {
    require_values(name, row.size(), columns.names.size());
    Series &series = declared(tables, name, columns, 0);
    if (is_in_file("tables/" + name, time))
      return false;
    series.time.push_back(time);
    append(series.values, row);
    return is_due(sizeof(double) * (1 + row.size()));
  }

  bool WriteBuffer::add_line(const std::string &name, const Columns &columns, const double time,
                             const LineSample &sample)
  {
    const std::size_t positions = sample.position.size();
    if (positions == 0)
      throw std::invalid_argument(name + ": a line needs positions");
    require_values(name, sample.values.size(), columns.names.size() * positions);
    Series &series = declared(lines, name, columns, positions);
    if (is_in_file("lines/" + name, time))
      return false;
    series.time.push_back(time);
    append(series.position, flattened(sample.position));
    append(series.values, sample.values);
    return is_due(sizeof(double) * (1 + 2 * positions + sample.values.size()));
  }

  bool WriteBuffer::add_outline(const std::string &name, const double time,
                                const std::vector<Polyline> &curves)
  {
    if (is_in_file("outlines/" + name, time))
      return false;
    outlines[name].push_back({time, curves});
    std::size_t bytes = 0;
    for (const Polyline &curve : curves)
      bytes += curve.size() * sizeof(Point);
    return is_due(bytes);
  }

  void WriteBuffer::write(const hid_t file)
  {
    for (auto &[name, series] : tables)
      write_series(file, "tables", name, series);
    for (auto &[name, series] : lines)
      write_series(file, "lines", name, series);
    for (auto &[name, timed] : outlines)
      for (const TimedOutline &outline : timed)
        write_outline(file, name, outline);
    for (const auto &[name, text] : texts)
      hdf5::set_attribute(file, name, text);
    for (const auto &[name, number] : numbers)
      hdf5::set_attribute(file, name, number);
    outlines.clear();
    texts.clear();
    numbers.clear();
    waiting_bytes = 0;
    since_write = {};
  }

  void WriteBuffer::write_snapshot(const hid_t file, const std::string &name, const double time,
                                   const Snapshot &snapshot)
  {
    const std::string folder = "snapshots/" + name;
    if (is_in_file(folder, time))
      return;
    const std::string index = std::to_string(hdf5::members(file, folder).size());
    const hdf5::Handle group = hdf5::open_group(file, folder + "/" + index, true);
    const auto nx = hsize_t(snapshot.nodes[0]), ny = hsize_t(snapshot.nodes[1]);
    hdf5::Shape shape{snapshot.vertex.size()};
    if (snapshot.kind == Snapshot::Kind::grid)
    {
      hdf5::set_attribute(group, "kind", std::string("grid"));
      hdf5::set_attribute(group, "origin", flattened({snapshot.origin}));
      hdf5::set_attribute(group, "spacing", flattened({snapshot.spacing}));
      std::vector<double> x(nx), y(ny);
      for (hsize_t i = 0; i < nx; ++i)
        x[i] = snapshot.origin[0] + double(i) * snapshot.spacing[0];
      for (hsize_t j = 0; j < ny; ++j)
        y[j] = snapshot.origin[1] + double(j) * snapshot.spacing[1];
      hdf5::write(group, "x", x);
      hdf5::write(group, "y", y);
      shape = {ny, nx};
    }
    else
    {
      const bool points = snapshot.kind == Snapshot::Kind::points;
      std::vector<int> connectivity = snapshot.connectivity;
      if (points) // each point is a cell of its own for readers of XDMF
      {
        connectivity.resize(snapshot.vertex.size());
        std::iota(connectivity.begin(), connectivity.end(), 0);
      }
      const hsize_t corners = points ? 1 : 4;
      shape = {connectivity.size() / corners};
      hdf5::set_attribute(group, "kind", std::string(points ? "points" : "cells"));
      hdf5::write(group, "vertex", flattened(snapshot.vertex), {snapshot.vertex.size(), 2});
      hdf5::write(group, "connectivity", connectivity, {shape[0], corners});
    }
    const hdf5::Handle fields = hdf5::open_group(group, "fields", true);
    for (const auto &[field, values] : snapshot.fields)
      hdf5::write(fields, field, values, shape);
    hdf5::set_attribute(group, "time", time); // last: without it the snapshot does not count
  }

  void WriteBuffer::resume(const hid_t file, const double time)
  {
    tables = take_up(file, "tables", time, kept_until);
    lines = take_up(file, "lines", time, kept_until);
    forget_later(file, "outlines", time, kept_until);
    forget_later(file, "snapshots", time, kept_until);
  }
} // namespace record
