#include "scene/value.h"
#include "solid/solid.h"

namespace solid
{
  NumericalError::NumericalError(const std::string &cause, const long step, const double time,
                                 const Point &place)
      : medium::NumericalError("numerical trouble in step " + std::to_string(step) + " at time " +
                               scene::number_text(time) + " near (" + scene::number_text(place[0]) +
                               ", " + scene::number_text(place[1]) + "): " + cause),
        step(step), time(time), place(place)
  {
  }
} // namespace solid
