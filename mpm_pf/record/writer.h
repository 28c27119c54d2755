// What was observed: the output of both solvers, one HDF5 file per run, with XDMF beside it for
// ParaView.
//
// Layout (read by record/reader.h, verify and postprocess; nothing else needs to know HDF5):
//
//   /                        attributes: format, program, status ("running", "complete",
//                            "failed: ..."), title, scene_hash, scene_file, and the solver's own
//   /provenance              attributes: see provenance.h; dataset scene (the merged TOML text)
//   /tables/<name>           attributes columns, units; time[n], values[n][k]
//                            (histories, reactions, means)
//   /lines/<name>            attributes columns, units; time[n], position[n][m][2],
//                            values[n][m][k], NaN = missing
//   /outlines/<name>/<i>     attribute time; offset[c+1], vertex[v][2]: curve j has the vertices
//                            offset[j] .. offset[j+1]-1 and is closed
//   /snapshots/<name>/<i>    attributes time, kind; fields/<quantity>
//                grid:       x[nx], y[ny]; attributes origin, spacing; fields [ny][nx]
//                points:     vertex[n][2], connectivity[n][1] (0, 1, 2 ...); fields [n]
//                cells:      vertex[v][2], connectivity[n][4]; fields [n]
//   /profile                 part[k], wall_s[k], cpu_s[k], calls[k]; attributes steps, cells,
//                            points, peak_rss_bytes ...
//
// Written as <path>.part, which nobody else may write (record/lock.h), and renamed by finish(): a
// crash leaves no half file under the final name. Rows wait in memory and reach the file in
// flush(), which opens and closes it: a kill in between leaves a whole .part to go on with.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "record/provenance.h"
#include "scene/scene.h"

namespace record
{
  using scene::Point;
  using scene::Polyline;

  struct Columns
  {
    std::vector<std::string> names, units;
  };

  /// A sampled line: m positions, m x k values row-major; NaN where no material is.
  struct LineSample
  {
    std::vector<Point> position;
    std::vector<double> values;
  };

  /// A whole-field snapshot. grid: nodal fields on the regular mesh (nodes[0] x nodes[1], x
  /// fastest); points: a cloud; cells: quadrilaterals (vertex, connectivity of 4) with one value
  /// per cell.
  struct Snapshot
  {
    enum class Kind
    {
      grid,
      points,
      cells
    } kind = Kind::points;
    Point origin = Point::Zero(), spacing = Point::Zero();
    std::array<int, 2> nodes{0, 0};
    std::vector<Point> vertex;
    std::vector<int> connectivity;
    std::map<std::string, std::vector<double>> fields;
  };

  struct Profile
  {
    struct Part
    {
      std::string name;
      double wall_s = 0., cpu_s = 0.;
      long calls = 0;
    };
    std::vector<Part> parts; // set-up, solve, output, and the solver's own parts
    std::map<std::string, double>
        numbers; // steps, cells, points, wall_s, cpu_s, peak_rss_bytes, bytes of each module ...
  };

  class Writer
  {
  public:
    /// Opens <path>.part. An earlier run's checkpoint beside it is removed first, since the new
    /// record lacks what came before it. Throws std::runtime_error if another process is writing it
    /// (`force` or not), if `path` exists and `force` is false, or if it cannot be written.
    Writer(const std::string &path, const Provenance &, const scene::Scene &, bool force);
    /// Goes on with the <path>.part of an interrupted run from a checkpoint at `time`: rows,
    /// outlines and snapshots later than that are forgotten, and what is observed again of those
    /// kept is dropped. Call flush() before saving a checkpoint. Throws std::runtime_error if there
    /// is no such file, it belongs to another scene, or another process is writing it.
    struct Resume
    {
      double time = 0.;
    };
    Writer(const std::string &path, const Provenance &, const scene::Scene &, Resume);
    ~Writer(); // an unfinished record stays <path>.part
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;

    /// Tables and lines are declared by their first call; later calls must have the same columns
    /// and, for lines, as many positions. Throw std::invalid_argument if they have not, if a
    /// snapshot's arrays do not fit its kind, or if a name is empty or holds '/'.
    void table(const std::string &name, const Columns &, double time,
               const std::vector<double> &row);
    void line(const std::string &name, const Columns &, double time, const LineSample &);
    void outline(const std::string &name, double time, const std::vector<Polyline> &);
    void snapshot(const std::string &name, double time, const Snapshot &);
    void attribute(const std::string &name, const std::string &value);
    void attribute(const std::string &name, double value);

    /// After this the rows so far survive a kill. Called by itself when much is waiting, and with
    /// every snapshot; never by the clock, so that what a run writes and when is the same on a slow
    /// machine: whoever wants rows to be seen in time calls flush_after(). Throws
    /// CannotWrite naming the file (disk full and the like), and so do finish() and all that
    /// record; <path>.part is broken then and gets no more.
    void flush();
    /// flush() if nothing has been written for so long, s.
    void flush_after(double seconds);
    /// Writes profile and status, the XDMF file beside it if there is a snapshot, and renames to
    /// the final name. Nothing may be recorded after it.
    void finish(const Profile &, const std::string &status = "complete");

  private:
    struct File;
    std::unique_ptr<File> file;
  };
} // namespace record
