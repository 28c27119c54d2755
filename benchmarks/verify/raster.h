// Whole fields of two programs side by side: means of a snapshot over the squares of a raster.
#pragma once

#include <string>
#include <vector>

#include "curve.h"
#include "quantity.h"
#include "record/reader.h"

namespace verify
{
  /// Centres of a snapshot's points, nodes or cells.
  std::vector<scene::Point> places(const record::Snapshot &);

  /// Values at some of a snapshot's places, by their number there.
  struct PlacedValues
  {
    const std::vector<std::size_t> &place;
    const std::vector<double> &value;
  };

  /// Mean of the values over squares of side `bin` (length), weighted by area: a point's own (field
  /// `area`), a node's cell, and of a cell as much as lies in the square. Squares that these places
  /// fill to less than three quarters are left out: a mean over the rest of an edge's square is
  /// that of another place. `mirror`: "x" (x -> -x), "y" (y -> -y), or as it is. Throws MissingData
  /// if `bin` is not positive, points have no area, or no square is filled.
  Raster rasterised(const record::Snapshot &, const PlacedValues &, double bin,
                    const std::string &mirror);

  /// Squares that both have, all of one weight. Throws MissingData if they are less than
  /// `coverage` (0 to 1) of those that either has.
  CommonSamples common_squares(const Raster &a, const Raster &b, double coverage);
} // namespace verify
