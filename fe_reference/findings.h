// What a reader of the record has to know of the march's mesh and equilibria.
#pragma once

#include "load_stepping.h"
#include "observer.h"
#include "record/writer.h"

namespace fe
{
  /// Attributes of the record, and a line on stderr for each that casts doubt on it: folded cells,
  /// a body that lies in itself, unstable equilibria. `end`: clock.end, time.
  void write_findings(record::Writer &, const Problem &, Observer &, const Outcome &, double end);
} // namespace fe
