// The melt's fields at given positions, for line and point probes of phi, theta, crystal_angle.
#pragma once

#include "record/writer.h"
#include "world.h"

/// What lies between the walls. Behind them is nothing, though the fields go on there for the
/// stencils' sake.
class BetweenWalls
{
public:
  explicit BetweenWalls(const World &);
  bool holds(const scene::Point &x) const;

private:
  scene::Point lower, upper; // a billionth of a cell wider
};

/// Bilinear values of `of`, one row per position; NaN outside the mesh, behind walls and
/// for what the melt does not know. Velocities are those of an imposed motion.
record::LineSample sample_melt(const World &, std::vector<scene::Point> positions,
                               const std::vector<std::string> &of);

/// Writes the columns of `solid`, named by `names`, over those of the same names among `of`.
void overlay(std::vector<double> &values, const std::vector<std::string> &of,
             const std::vector<double> &solid, const std::vector<std::string> &names);

/// `count` equidistant positions from a to b, both included.
std::vector<scene::Point> positions_of(const scene::LineProbe &);
