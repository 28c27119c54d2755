// Energies and momentum of the points.
//
// Elastic energy a volume for Hooke's law: q^2/6G + p^2/2K. The balance work + start - kinetic -
// elastic - dissipated is what the scheme itself takes away (transfers damp what the grid cannot
// carry), and an error of the order of the step in the work of supports that are speeding up.
#pragma once

#include "solid/solid.h"

namespace solid
{
  double kinetic_energy(const Solid &);
  double elastic_energy(const Solid &);
  Point momentum(const Solid &);
  double area(const Solid &);
  double mass(const Solid &);
  /// What the account above lacks; negative where more is there than was ever given.
  double energy_balance(const Solid &);

  /// Largest speed and energy of points that have just been made: what the account starts from.
  void begin_account(Solid &);
} // namespace solid
