// The melt's fields at given positions, for line and point probes of phi, theta, crystal_angle.
#pragma once

#include "record/writer.h"
#include "world.h"

/// Whether a probe asks for a quantity of the melt (scene/quantities.h).
bool asks_the_melt(const scene::Probe &);

/// Bilinear values of `of`, one row per position; NaN outside the mesh or where a module is absent.
record::LineSample sample_melt(const World &, std::vector<scene::Point> positions,
                               const std::vector<std::string> &of);

/// `count` equidistant positions from a to b, both included.
std::vector<scene::Point> positions_of(const scene::LineProbe &);
