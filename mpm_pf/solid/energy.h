// Energies and momentum of the points.
//
// Elastic energy a volume for Hooke's law: q^2/6G + p^2/2K.
//
// Of what supports and loads work, and what was there at the start, part is kinetic energy now,
// part was work of the stresses on the strains, sum V (sigma + d sigma/2) : d eps. The rest is the
// numerical dissipation of the transfers, transfer_loss: points take smoothed velocities from the
// nodes, and give them smoothed once more; light nodes are held back (light_nodes.h). Forces of a
// step's start work on the mean of the velocities before and after it, and stresses of that mean on
// the strains: over an oscillation or a revolution neither gains nor loses. (On the velocity after
// it a force F works 1/2 dt^2 dF/dt.v too little a step, always of one sign where a force keeps up
// with a motion.)
//
// The balance, that work of the stresses less elastic energy gained and dissipated, is what remains
// unaccounted for: pressures relaxed and strains averaged (anti_locking.h: 0.5 % of a crystal's
// compression, without them 3e-5), and the hypoelastic law at large changes of volume.
#pragma once

#include "solid/points.h"
#include "solid/solid.h"

namespace solid
{
  /// Of point p.
  double kinetic_energy_of(const Points &, std::size_t p);
  double elastic_energy_of(const Solid &, std::size_t p);

  /// Sums over the points.
  double kinetic_energy(const Solid &);
  double elastic_energy(const Solid &);
  Point momentum(const Solid &);
  double area(const Solid &);
  double mass(const Solid &);
  /// transfer_loss and the balance together: what came in and is neither there nor dissipated;
  /// negative where more is there than was ever given.
  double missing_energy(const Solid &);

  /// Largest speed and energy of points that have just been made: what the account starts from.
  void start_energy_account(Solid &);
} // namespace solid
