// How large a crystal will be, predicted from its material: the tip velocity by Ivantsov's parabola
// in two dimensions and a fit of solvability theory.
//
//   Delta = sqrt(pi Pe) exp(Pe) erfc(sqrt(Pe)),   V d0/D = 2 sigma Pe^2,   sigma = 2.2 eps^0.95.
//
// The fit goes through the two velocities of paper Table 1 (Delta = 0.55: V d0/D = 0.01703 at
// eps = 0.05 and 0.00542 at 0.015). It serves to predict cost, nothing else.
#pragma once

#include "world.h"

/// Peclet number of Ivantsov's parabola for an undercooling between 0 and 1.
double peclet_number(double undercooling);

/// Tip velocity, length per time; 0 where nothing drives the tip.
double tip_velocity(const scene::Scene &);

/// Radius 2 Pe D/V of Ivantsov's parabola, length; 0 where nothing drives it. The tip of a crystal
/// of strong anisotropy is sharper than that.
double tip_radius(const scene::Scene &);

/// What growth has to do in a whole run.
struct GrowthLoad
{
  double end = 0.;          // time at which the run will end (walls may end it early)
  double active_nodes = 0.; // mean over the run: both equations
  double heated_nodes = 0.; // mean over the run: heat alone
  double pressed_from =
      0.; // time at which a wall meets the crystal; `end` if none does, 0 if none is
  double solid_area = 0.; // then, inside the domain
  bool grows = false;     // is it larger then than at the start?
};

/// Of a scene with [growth].
GrowthLoad growth_load(const World &);
