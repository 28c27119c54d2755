// What is checked after every step: points that have gone wrong, and energy from nowhere.
//
// A block of points that has one which is not finite, inside out, out of the domain or faster than
// half a cell a step names it while it moves them (constitutive.h); what is wrong with it is found
// out here. Kinetic energy is summed while the points move and compared in every step, that of
// the stresses every 32 steps.
#pragma once

namespace solid
{
  struct Solid;

  /// Sums of the blocks' shares of the step of length dt that has just been made. Throws
  /// NumericalError: a point gone wrong, or more than twice the energy that was ever put in.
  void check_state(Solid &, double dt);
} // namespace solid
