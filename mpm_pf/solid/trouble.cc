#include "solid/solid.h"

namespace solid
{
  Trouble::Trouble(const std::string &cause, const long step, const double time, const Point &place)
      : std::runtime_error("numerical trouble in step " + std::to_string(step) + " at time " +
                           std::to_string(time) + " near (" + std::to_string(place[0]) + ", " +
                           std::to_string(place[1]) + "): " + cause),
        step(step), time(time), place(place)
  {
  }
} // namespace solid
