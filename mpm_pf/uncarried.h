// Motion that the melt's fields have not followed yet: with advection.interval above 1 the way of
// every node adds up over the coupling steps, and the fields are carried all of it at once.
//
//   way = sum of v dt over T,   then   df/dt + (way/T) . grad f = 0   over T
//
// A steady motion is carried as by one step of T; one that changes, by its mean, second order in T.
// Until then the fields lag behind the material by the way: by less than the scheme can carry at
// once, since is_due() says so before, and by nothing where a probe looks (simulate.cc).
#pragma once

#include "medium/advection.h"

struct Uncarried
{
  Uncarried(const medium::Mesh &mesh, const int interval, const bool of_a_solid)
      : interval(interval), way(mesh)
  {
    if (of_a_solid)
      material = medium::Field<unsigned char>(mesh);
  }

  int interval;                          // advection.interval, coupling steps
  medium::Velocity way;                  // since the last advection, length
  medium::Field<unsigned char> material; // 1 where the solid's velocity rests on mass; else empty
  double time = 0.;                      // T so far
  long steps = 0;                        // coupling steps so far
  double shift = 0.; // cells along an axis, the most of any node: of all the way so far
  double last = 0.;  // and of the last step

  std::size_t bytes() const { return way.x.bytes() + way.y.bytes() + material.bytes(); }
};

/// Adds `velocity` (ghosts filled) times dt to the way.
void add_step(Uncarried &, const medium::Velocity &velocity, double dt, const medium::Mesh &);

/// Whether the fields are to be carried now: the interval is over, or one more step like the last
/// would go further than `room`, in cells.
bool is_due(const Uncarried &, double room);

/// The mean velocity over the time so far, in place of the way; restart() when it has been used.
const medium::Velocity &mean_velocity(Uncarried &);
void restart(Uncarried &);

/// Coupling steps from one advection to the next if each crosses `shift` cells: at least 1.
double steps_between_advections(int interval, double shift, double room);
