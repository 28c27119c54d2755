// Reads what writer.h wrote; used by verify, by scenes that start from a record, and by tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "record/writer.h"

namespace record
{
  struct Table
  {
    Columns columns;
    std::vector<double> time;
    std::vector<std::vector<double>> rows;
  };
  struct Lines
  {
    Columns columns;
    std::vector<double> time;
    std::vector<LineSample> samples;
  };
  struct Outlines
  {
    std::vector<double> time;
    std::vector<std::vector<Polyline>> outlines;
  };

  class Reader
  {
  public:
    /// Throws std::runtime_error naming file and cause (absent, unfinished, not ours).
    explicit Reader(const std::string &path);
    ~Reader();

    std::string status() const;
    std::string attribute(const std::string &name) const; // of the file or provenance; "" if absent
    double number(const std::string &name) const;         // of the file or profile; NaN if absent
    Provenance provenance() const;
    std::string scene_text() const; // the merged TOML
    std::vector<std::string> tables() const, lines() const, outlines() const, snapshots() const;
    /// Throw std::runtime_error listing the names present if there is none of that name.
    Table table(const std::string &name) const;
    Lines line(const std::string &name) const;
    Outlines outline(const std::string &name) const;
    std::vector<double> snapshot_times(const std::string &name) const;
    Snapshot snapshot(const std::string &name, std::size_t index) const;
    Profile profile() const;

  private:
    struct File;
    std::unique_ptr<File> file;
  };
} // namespace record
