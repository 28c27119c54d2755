// The crystal angle, Eq. (3), with half the printed curl:
//
//   d Theta/dt + v . grad Theta = 1/2 (dv/dx - du/dy)        (angles in radians, counter-clockwise
//   +)
//
// A rigid rotation at rate omega has the curl 2 omega; with the full curl a crystal would turn
// twice as far as its body (45 degrees would become 90, which a four-fold crystal cannot tell from
// 0, and so hide the error from all but a rotation test). The lattice turns with the material spin.
//
// Carried is the unwrapped angle itself, not cos and sin of four times it: the spin is then a plain
// addition, exact for a rigid rotation; one field is advected instead of two; no renormalisation
// pulls at the anisotropy; the record tells a lattice turned by 90 degrees from one at rest; and
// the extension into the liquid is that of any scalar. The price is that grains whose angles differ
// by more than 45 degrees are not seen as closer through the four-fold symmetry; the model has no
// grain boundaries anyway. Growth reads cos and sin of four times the angle, refreshed after each
// turn.
#pragma once

#include "medium/advection.h"
#include "medium/extension.h"
#include "medium/field.h"

namespace melt
{
  using medium::Field;
  using medium::Mesh;

  struct Orientation
  {
    /// While nothing has turned the angle is one number and the fields are empty.
    double uniform_angle = 0.;  // radians
    double uniform_cosine = 1.; // of four times it
    double uniform_sine = 0.;
    Field<double> angle;        // radians, unwrapped
    Field<double> cosine, sine; // of four times the angle
    medium::Gradients gradients;

    bool varying() const { return !angle.empty(); }
    std::size_t bytes() const;
  };

  /// A uniform crystal angle. Multiples of 22.5 degrees get exact cosines and sines of four times
  /// it.
  Orientation make_orientation(double angle_degrees);

  /// Gives every node its own angle: allocates the fields, uniform so far. Does nothing if they
  /// are.
  void allocate_angle_field(Orientation &, const Mesh &);

  /// cos and sin of four times `angle` (radians), to 1e-15, without a library call; fields of equal
  /// shape, ghosts included.
  void cos_sin_of_four_times(const Field<double> &angle, Field<double> &cosine,
                             Field<double> &sine);

  /// To be called after `angle` was changed by anything but advance_orientation() (extension,
  /// restart): fills its ghosts and refreshes cosine and sine.
  void refresh(Orientation &, const Mesh &);

  /// Eq. (3) over dt: advects the angle and adds the spin at the departure's arrival node, then
  /// refreshes. Ghosts of `velocity` must be filled. `front`, if not null, is what the velocity was
  /// extended into the melt with, x then y: the solid's spin is then that of the solid right up to
  /// its front.
  void advance_orientation(Orientation &, const medium::Velocity &, double dt, const Mesh &,
                           medium::Advection &, const medium::Extension *front = nullptr);
} // namespace melt
