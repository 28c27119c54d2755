// Is a compression quasi-static? Inertia alone can fake "plasticity near the walls" (paper, Sec.
// 3): to stop or move an arm of length a by one yield stress takes a rho V^2/sigma_Y of a wall's
// travel at speed V, whatever the material does.
#pragma once

#include <string>

#include "solid/moving_walls.h"
#include "world.h"

struct Inertia
{
  double arm = 0.;      // of the crystal before the fastest wall, length
  bool opposed = false; // is there a wall on the other side?
  solid::QuasiStatic numbers;
  /// Share of compression that inertia alone accounts for.
  double compression() const { return arm > 0. ? numbers.inertia_travel / arm : 0.; }
};

/// Length of the material before a wall, up to a mirror or the middle between it and the opposite
/// side.
double arm(const World &, const medium::Wall &);

/// Of a world with a solid between walls.
Inertia inertia(const World &);

/// The same in words, for the record and the figures; empty where no wall has compressed a solid.
std::string verdict_on_inertia(const World &);

/// A sentence if the density was scaled so far that a wave crosses the bodies a few times only in
/// the whole run, or that of bodies which start with a velocity: whatever is loaded then is not in
/// equilibrium. Empty else.
std::string warning_on_scaling(const World &);

/// A sentence if bodies whose density is scaled, so as to be loaded slowly, had more than a
/// twentieth of their energy in their motion, in the mean over the run: the scale was set by waves
/// through them, but a slender body bends slower than that. Squeezed dendrites with a share of 12 %
/// bear 2 % too much in the mean and their two ends differ by a quarter; a beam eight times as long
/// as high with 21 % rang by three times its collapse load. Empty between walls, which have their
/// own verdict, and else.
std::string warning_on_kinetic_energy(const World &);

/// A sentence if more than a tenth of the energy that the solid was given is nowhere any more, or
/// came from nowhere. Empty else.
std::string warning_on_energy(const World &);

/// A sentence if a wall that should have moved never started: no front came near enough to it.
/// Empty else.
std::string warning_on_idle_walls(const World &);

/// A sentence if a wall went its way before a solid and met nothing. Empty else.
std::string warning_on_missing_walls(const World &);
