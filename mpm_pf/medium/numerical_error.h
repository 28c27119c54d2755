// Numerical trouble: a run that cannot go on (not finite, not converged), as against a wrong scene.
#pragma once

#include <stdexcept>
#include <string>

namespace medium
{
  /// Thrown with step, time and place in the text; the program maps it to exit code 3.
  class NumericalError : public std::runtime_error
  {
  public:
    explicit NumericalError(const std::string &what) : std::runtime_error(what) {}
  };
} // namespace medium
