// What a world costs, held and spent, by module: for the forecast before a run and the record after
// it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/writer.h"
#include "world.h"

/// Bytes held, by module and part ("solid points", "solid grid", "phase field", ...); a module that
/// is absent has no entry.
std::map<std::string, double> memory(const World &);

/// Seconds by part of the solvers.
std::vector<record::Profile::Part> parts(const World &);

/// Numbers worth keeping: points, cells, steps, density in use, ...; only of the present modules.
std::map<std::string, double> numbers(const World &);
