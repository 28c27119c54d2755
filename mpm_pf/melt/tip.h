// The dendrite tip along a ray: where it is, how fast it goes, how sharp it is.
//
// All from psi = sqrt(2) W0 atanh phi, which runs straight across the interface: interpolating phi
// itself would move the tip to and fro within a cell and spoil its curvature.
//   position  the outermost crossing from solid to liquid, on a bicubic through 4 x 4 nodes
//   radius    of curvature of the curve t^2 + a t + b t s = 2 rho s + q s^2 + r s^3 fitted by least
//             squares (of t^2 over t^2) to the crossings on parallels of the ray a mesh line apart,
//             within a window of the tip; s is the depth behind it, t the distance from the ray. A
//             dendrite's tip is a sharp cap on a much blunter parabola, so that depth over distance
//             converges slowly; all conics are met exactly. Beyond a symmetry wall the mirror image
//             counts
//   velocity  least-squares slope of position over time across a window of travel of some cells,
//             because the tip sticks a little at every node it passes
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "medium/field.h"

namespace melt
{
  using medium::Field;
  using medium::Mesh;
  using medium::Point;

  struct Ray
  {
    Point origin, direction; // direction need not be a unit vector
  };

  struct Tip
  {
    double position = 0.; // distance from the ray's origin, length
    double radius = 0.;   // length; NaN if too few parallels meet the front; negative if concave
    double residual = 0.; // of the fit, root mean square along the ray, length
    double window = 0.;   // of the fit: parallels up to this distance on both sides, length
    int crossings = 0;    // fitted; the fit has five coefficients
  };

  /// The tip on a ray, or nothing if the ray meets no solid or is solid up to the border. `width`:
  /// W0. Throws std::invalid_argument if the origin lies outside the mesh or the direction is zero.
  std::optional<Tip> find_tip(const Field<double> &phi, const Mesh &, const Ray &, double width);

  /// Positions of one tip over time; plain data, part of a checkpoint.
  struct TipTrack
  {
    std::vector<double> time, position;
  };

  struct TipVelocity
  {
    double value = 0.;    // length per time; NaN before there are three samples
    double travel = 0.;   // of the window, length
    double residual = 0.; // root mean square of the positions about the line, length
    int samples = 0;
  };

  /// Appends a sample and forgets those that no window of `travel` needs any more.
  void add_sample(TipTrack &, double time, double position, double travel);

  /// Slope of the line through the latest samples over which the tip went `travel` (length), or
  /// all.
  TipVelocity tip_velocity(const TipTrack &, double travel);

  /// Travel of the window unless the caller says otherwise: ten cells.
  double default_travel(const Mesh &);

  /// Why a tip of this radius is not resolved on this mesh with this interface width, as a sentence
  /// with numbers and remedy; empty if it is: at least two cells, and at least W0, per radius.
  std::string resolution_warning(double radius, const Mesh &, double width);
} // namespace melt
