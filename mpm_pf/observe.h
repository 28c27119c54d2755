// How each kind of probe samples the world and what it writes; a probe of a module that is absent
// was refused with the scene.
#pragma once

#include "record/writer.h"
#include "world.h"

void observe(const scene::LineProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::PointProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::RegionProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::ReactionProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::OutlineProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::SnapshotProbe &, const scene::Probe &, const World &, record::Writer &);
void observe(const scene::HistoryProbe &, const scene::Probe &, const World &, record::Writer &);
