// What waits in memory between two flushes of a record, and how it gets into the file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/hdf5_file.h"
#include "record/stopwatch.h"
#include "record/writer.h"

namespace record
{
  /// Rows of one table or line that wait; `width` values a row, `positions` points a row (0:
  /// table).
  struct Series
  {
    Columns columns;
    std::size_t positions = 0;
    std::vector<double> time, position, values;
    bool in_file = false;
  };

  struct TimedOutline
  {
    double time;
    std::vector<Polyline> curves;
  };

  class WriteBuffer
  {
  public:
    std::map<std::string, std::string> texts;
    std::map<std::string, double> numbers;

    /// Each returns whether so much waits that it should be written.
    bool add_row(const std::string &name, const Columns &, double time,
                 const std::vector<double> &row);
    bool add_line(const std::string &name, const Columns &, double time, const LineSample &);
    bool add_outline(const std::string &name, double time, const std::vector<Polyline> &);

    /// Append all that waits to the open file and forget it here.
    void write(hid_t file);
    void write_snapshot(hid_t file, const std::string &name, double time, const Snapshot &);

    /// Seconds since the last write().
    double wait() const { return since_write.wall_seconds(); }

    /// Take up an interrupted record: forget in `file` what is later than `time`, and learn what
    /// is declared there. What the resumed run observes a second time is dropped: a mean over a
    /// window that reaches past the checkpoint is dated before it but came into the file after it.
    void resume(hid_t file, double time);

  private:
    std::map<std::string, Series> tables, lines;
    std::map<std::string, std::vector<TimedOutline>> outlines;
    std::map<std::string, double> kept_until; // "tables/<name>" ...: last time kept by resume()
    std::size_t waiting_bytes = 0;
    Stopwatch since_write;

    bool is_due(std::size_t added_bytes);
    bool is_in_file(const std::string &path, double time) const;
  };
} // namespace record
