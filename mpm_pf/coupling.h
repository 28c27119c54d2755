// Where the solid and the melt meet: v goes from the material points to the melt's fields, phi
// comes back. Both sides see plain nodal fields; nothing here knows how either of them works.
#pragma once

#include "world.h"

/// Whether the world has a solid that moves something of the melt's.
bool coupled(const World &);

/// Start the walls that a tip has come near to, and move all that have started by dt.
void move_walls(World &, double dt);

/// The velocity of an imposed motion, at the middle of dt, to every node.
void impose(World &, double dt);

/// A growing solid that has nothing to wait for gets its points: once a wall touches it, or at once
/// where there are no walls. Else it moves nowhere, and no point exists.
void activate_solid(World &);

/// Advance the solid by dt (Eqs. (4)-(6)) and give every node of the mesh its velocity: the mean
/// over dt (free of elastic ringing) where there is material, its zero-gradient extension elsewhere
/// [13]-[15]. A solid that nothing has touched yet has no points and no velocity.
void move_solid(World &, double dt);

/// Advance a solid beside which nothing is carried.
void move_solid_alone(World &, double dt);

/// The melt's fields end at the walls' new places.
void update_cuts(World &);

/// v . grad of Eqs. (1)-(3): everything that the melt carries follows the velocity over dt; then
/// the fields end at the walls again. With advection.interval above 1 the way of dt may wait for
/// that of later steps (uncarried.h).
void advect_melt(World &, double dt);

/// Where the motion has gone on without the melt's fields they follow it now: so that what is
/// recorded together is of one time.
void catch_up(World &);

/// Coupling steps from one advection to the next if each crosses `shift` cells along an axis.
double steps_between_advections(const World &, double shift);

/// Right sides of Eqs. (1) and (2) over dt; what has grown becomes material points.
void grow(World &, double dt);
