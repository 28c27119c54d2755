// Which tiles come near the contour: those of the distance's band, and those in which a contour
// that has moved a little is looked for.
#pragma once

#include "medium/distance.h"

namespace medium
{
  /// Judges `tiles` and `close` of the distance by its pieces.
  void mark_tiles(Distance &, const Mesh &);
} // namespace medium
