// Does a scene fit into this machine? Asked before anything is allocated.
#pragma once

#include "scene/scene.h"

/// Least number of bytes that the fields and points of a scene take, by its cells and the area of
/// its bodies.
double least_bytes(const scene::Scene &);

/// Throws scene::BadScene if `bytes` exceed what this machine has, naming [domain] cells.
void refuse_more_than_memory(const scene::Scene &, double bytes);
