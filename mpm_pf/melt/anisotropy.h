// The anisotropy of W and tau without an angle: cos and sin of four times the normal's angle are
// polynomials in the gradient.
//
//   xi = 1 + eps cos 4(theta_n - crystal_angle),   W = W0 xi,   tau = tau0 xi^2
//   cos 4 theta_n = 1 - 8 n^2 t^2/s^2,  sin 4 theta_n = 4 n t (n^2 - t^2)/s^2,  s = n^2 + t^2
//
// with n, t the two components of grad phi. The paper calls two things alpha; here theta_n is the
// angle of the interface normal and crystal_angle the field of Eq. (3), entering only through cos
// and sin of four times it. The printed W(alpha) = alpha xi(alpha) is a misprint for W0 xi.
//
// Where the gradient vanishes the angle is meaningless. In the flux s is guarded, and the flux goes
// to zero with the gradient whatever xi is; in the relaxation s^2 is, and xi tends to 1. Because
// these are powers of a gradient, the guard depends on the number type: gradients (differences of
// phi from node to node) below it count as none.
//
// Every function here gives the same bits for a mirrored or transposed argument, so that a
// four-fold crystal stays four-fold to the last bit.
#pragma once

#include <cmath>

namespace melt
{
  template <class Real>
  inline constexpr Real gradient_guard = Real(1e-10);
  template <>
  inline constexpr float gradient_guard<float> = 1e-5f; // beyond float's rounding of phi

  /// Flux of Eq. (1) through a face, over W0^2:
  ///   (xi^2 - 1) n - xi xi' t + isotropic n,   xi' = d xi/d theta_n = -4 eps sin 4(theta_n - ...);
  /// the rest of the isotropic part, (1 - isotropic) n, is that of the Laplacian's corners. n, t:
  /// gradient normal to and along the face; cosine, sine: eps times those of four times the crystal
  /// angle. For a face normal to y pass -sine: there (n, t) is a left-handed pair.
  template <class Real>
  inline Real face_flux(Real n, Real t, Real cosine, Real sine, Real isotropic)
  {
    const Real inverse = 1 / (n * n + t * t + gradient_guard<Real> * gradient_guard<Real>);
    const Real c2 = (n * n - t * t) * inverse, half_s2 = n * t * inverse;
    const Real p = half_s2 * half_s2, q = c2 * half_s2; // cos 4 theta_n = 1 - 8 p, sin = 4 q
    const Real excess = cosine - 8 * cosine * p + 4 * sine * q;        // xi - 1
    const Real turning = 16 * cosine * q + (32 * sine * p - 4 * sine); // -xi'
    return n * (excess * (excess + 2) + isotropic) + turning * t * (excess + 1);
  }

  /// tau0/tau = 1/xi^2 at a node from its gradient (gx, gy), up to any factor.
  template <class Real>
  inline Real inverse_relaxation(Real gx, Real gy, Real cosine, Real sine)
  {
    constexpr Real guard = gradient_guard<Real> * gradient_guard<Real>;
    const Real product = gx * gy, size = std::fabs(gx) + std::fabs(gy);
    const Real s = size * size - 2 * std::fabs(product); // gx^2 + gy^2, same bits when transposed
    const Real guarded = s * s + guard * guard;
    const Real q = product * ((gx - gy) * (gx + gy));
    const Real ratio = guarded / (guarded + cosine * (s * s) - // 1/xi
                                  8 * cosine * (product * product) + 4 * sine * q);
    return ratio * ratio;
  }
} // namespace melt
