// Sampling the deformed body: where is a point, what is the mean of a quantity around it.
//
// Unlike discretisations are compared by means over fixed squares, never by nodal averages. Each
// integration point stands for its own patch of the cell (in the unit square the patches are the
// products of the one-dimensional Gauss weights, so their areas are exactly the weights); a patch
// is split into a few samples that carry its stress, and a bin averages the samples whose position
// lies in it, weighted by their current area. Displacements and velocities are continuous and are
// interpolated in the deformed cell that holds the point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "quantities.h"

namespace fe
{
  /// A body at one instant, whole on this process.
  struct Snapshot
  {
    const Problem &problem;
    double time;
    std::vector<double> u, velocity; // unknowns
    std::vector<PointState> points;  // cells x points
    std::vector<char> folded;        // cells: det F <= 0 at one of its nodes
    // Where material starts; empty: where the mesh has cells.
    std::function<bool(const Point &)> starts_in = {};
  };

  /// Gathers the points of all processes; every process must call it. `velocity` is the mean over
  /// the increment from `before`, zero if they are the same.
  Snapshot make_snapshot(const Problem &, const State &now, const State &before);

  /// Cells in which the mesh folds at a node, and the smallest nodal det F.
  std::vector<char> folded_cells(const Problem &, const std::vector<double> &u, double &smallest);

  /// Where the point is: cell and unit coordinates.
  struct Location
  {
    int cell;
    Point unit;
  };
  /// Holds the cell, its curved sides, too.
  scene::Box box_of_cell(const Snapshot &, int cell, scene::Frame);

  /// Cell that holds `x` (current or, with Frame::material, initial position); empty outside.
  std::optional<Location> locate(const Snapshot &, const Point &x, scene::Frame);
  /// The same; a point between a curved outline and the chord that a side of the mesh makes of it,
  /// asked for by its initial position, is looked for on that side.
  std::optional<Location> locate_material(const Snapshot &, const Point &x, scene::Frame);

  /// Values of `names` at `x` interpolated in the cell: displacements by shape functions, others
  /// from the patch that holds the point. NaN outside the body and in folded cells.
  std::vector<double> values_at(const Snapshot &, const Point &x, scene::Frame,
                                const std::vector<std::string> &names);

  /// A point probe: stresses as means over the square bin around it, by current area, displacements
  /// interpolated. A bin that is too small to meet a sample of a patch has the value of the patch.
  std::vector<double> sample_point(const Snapshot &, const scene::PointProbe &,
                                   const std::vector<std::string> &names, double default_bin);
  /// A line probe: the same at each of its points.
  record::LineSample sample_line(const Snapshot &, const scene::LineProbe &,
                                 const std::vector<std::string> &names, double default_bin);

  /// Means over the material that started in the probe's box, weighted by current area; "area" is
  /// the sum.
  std::vector<double> region_means(const Snapshot &, const scene::RegionProbe &,
                                   const std::vector<std::string> &names);

  /// Element means, one value a cell, and the deformed corners; the field "valid" is 0 in folded
  /// cells.
  record::Snapshot cell_snapshot(const Snapshot &, const std::vector<std::string> &names);

  /// The deformed outline as closed polylines, counter-clockwise around the material.
  std::vector<scene::Polyline> outlines(const Snapshot &);

  /// Current (or initial) position, and dx/d(unit), of unit coordinates in a cell.
  Point position_in(const Snapshot &, const Location &, scene::Frame, Matrix2 *slope = nullptr);
} // namespace fe
