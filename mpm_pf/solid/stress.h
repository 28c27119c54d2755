// Stress of a point over one step: Jaumann rate, Hooke, J2 viscoplasticity; Eqs. (5) and (6).
//
// The velocity gradient L of the step (x_new = x + dt L x) is taken to the mid configuration,
// L (I + dt L/2)^-1, whose symmetric part vanishes exactly in a rigid rotation. The old stress is
// turned by Hughes and Winget's Q = (I - W dt/2)^-1 (I + W dt/2) (Int. J. Numer. Meth. Eng. 15,
// 1980), then the elastic trial is returned radially. Perzyna's law in closed form, with trial von
// Mises q:
//   d gamma = (q - sigma_Y)/(3 G + eta/dt),  s = s_trial (1 - 3 G d gamma/q)
// backward Euler, stable for any step; eta = 0 is the rate-independent return, and eta -> infinity
// is *elastic* (the paper's "eta very large" for rate independence contradicts its own Eq. (6)).
// The pressure follows a volumetric strain given from outside, so that it may be the mean of a cell
// (anti_locking.h).
#pragma once

#include <algorithm>
#include <cmath>

#include "solid/material.h"

namespace solid
{
  /// In-plane components and sigma_zz.
  struct Stress
  {
    double xx, yy, zz, xy;
  };

  inline double pressure(const Stress &s)
  {
    return -(s.xx + s.yy + s.zz) * (1. / 3.);
  }

  inline double von_mises(const Stress &s)
  {
    const double a = s.xx - s.yy, b = s.yy - s.zz, c = s.zz - s.xx;
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3. * s.xy * s.xy);
  }

  /// Strain and rotation of one step, dimensionless: dt times the mid-configuration gradient.
  struct Increment
  {
    double xx, yy, xy; // strain; xy is the tensor component
    double spin;       // counter-clockwise, dt (dv/dx - du/dy)/2
  };

  inline __attribute__((always_inline)) Increment
  increment(const double lxx, const double lxy, const double lyx, const double lyy, const double dt)
  {
    const double a = dt * lxx, b = dt * lxy, c = dt * lyx, d = dt * lyy;
    const double det = a * d - b * c;
    const double scale = 1. / (1. + 0.5 * (a + d) + 0.25 * det);
    return {scale * (a + 0.5 * det), scale * (d + 0.5 * det), scale * 0.5 * (b + c),
            scale * 0.5 * (c - b)};
  }

  /// Hughes-Winget: Q sigma Q^T for the spin of one step.
  inline __attribute__((always_inline)) Stress turned(const Stress &s, const double spin)
  {
    const double half = 0.5 * spin, scale = 1. / (1. + half * half);
    const double cosine = (1. - half * half) * scale, sine = spin * scale;
    const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    const double shear = 2. * cs * s.xy;
    return {cc * s.xx + ss * s.yy - shear, ss * s.xx + cc * s.yy + shear, s.zz,
            cs * (s.xx - s.yy) + (cc - ss) * s.xy};
  }

  /// Constants of one step of the flow rule. viscosity_rate = eta/dt.
  struct Flow
  {
    double shear, bulk, yield_stress, viscosity_rate;
  };

  struct Updated
  {
    Stress stress;
    double plastic;    // increment of equivalent plastic strain
    double dissipated; // per current volume
    double work;       // of the mean stress on the strain, per current volume
  };

  /// One step; `volumetric` is the increment of volume strain that drives the pressure.
  /// plastic = false leaves the trial state.
  template <bool plastic>
  inline __attribute__((always_inline)) Updated update(const Stress &old, const Increment &e,
                                                       const double volumetric, const Flow &flow)
  {
    const Stress s = turned(old, e.spin);
    const double mean = (s.xx + s.yy + s.zz) * (1. / 3.), third = (e.xx + e.yy) * (1. / 3.);
    const double two_g = 2. * flow.shear;
    double xx = s.xx - mean + two_g * (e.xx - third), yy = s.yy - mean + two_g * (e.yy - third);
    double xy = s.xy + two_g * e.xy, zz = -(xx + yy);
    const double p = mean + flow.bulk * volumetric;
    const auto work = [&](const Stress &to)
    { return 0.5 * ((to.xx + s.xx) * e.xx + (to.yy + s.yy) * e.yy) + (to.xy + s.xy) * e.xy; };
    if constexpr (!plastic)
    {
      const Stress to{xx + p, yy + p, zz + p, xy};
      return {to, 0., 0., work(to)};
    }
    const double q2 = 1.5 * (xx * xx + yy * yy + zz * zz) + 3. * xy * xy;
    const double q = std::sqrt(std::max(q2, 1e-300));
    const double compliance = 1. / (3. * flow.shear + flow.viscosity_rate); // once for all points
    const double over = std::max(q - flow.yield_stress, 0.);                // {f_Y}
    const double gamma = over * compliance;                                 // Eq. (6), closed form
    const double keep = 1. - 3. * flow.shear * gamma / q;                   // Eq. (5), along s
    xx *= keep, yy *= keep, zz *= keep, xy *= keep;
    const Stress to{xx + p, yy + p, zz + p, xy};
    return {to, gamma, gamma * q * keep, work(to)};
  }
} // namespace solid
