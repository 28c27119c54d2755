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
// Where the gradient vanishes the angle is meaningless: 1/s^2 is guarded so that xi tends to 1.
// Because s^2 is a fourth power of a gradient, the guard depends on the number type: gradients
// (differences of phi from node to node) below the guard's fourth root count as none.
//
// Every function here gives the same bits for a mirrored or transposed argument, so that a
// four-fold crystal stays four-fold to the last bit.
#pragma once

namespace melt
{
  template <class Real>
  inline constexpr Real gradient_guard = Real(1e-40); // node-to-node differences below 1e-10
  template <>
  inline constexpr float gradient_guard<float> = 1e-20f; // 1e-5: beyond float's rounding of phi

  /// Anisotropic part of the flux of Eq. (1) through a face, over W0^2:
  ///   (xi^2 - 1) n - xi xi' t,   xi' = d xi/d theta_n = -4 eps sin 4(theta_n - crystal_angle);
  /// the isotropic rest, n, is taken by the Laplacian. n, t: gradient normal to and along the face;
  /// cosine, sine of four times the crystal angle. For a face normal to y pass -sine: there (n, t)
  /// is a left-handed pair.
  template <class Real>
  inline Real anisotropic_flux(Real n, Real t, Real cosine, Real sine, Real eps)
  {
    const Real nn = n * n, tt = t * t, s = nn + tt, nt = n * t;
    const Real square = s * s;
    const Real inverse = eps / (square + gradient_guard<Real>);
    const Real c4 = square - 8 * (nn * tt), s4 = 4 * nt * (nn - tt);
    const Real e_c = (c4 * cosine + s4 * sine) * inverse; // xi - 1
    const Real e_s = (s4 * cosine - c4 * sine) * inverse; // -xi'/4
    const Real xi = 1 + e_c;
    return e_c * (1 + xi) * n + 4 * xi * e_s * t;
  }

  /// tau0/tau = 1/xi^2 at a node from its gradient (gx, gy).
  template <class Real>
  inline Real inverse_relaxation(Real gx, Real gy, Real cosine, Real sine, Real eps)
  {
    const Real product = gx * gy;
    const Real size = (gx < 0 ? -gx : gx) + (gy < 0 ? -gy : gy);
    const Real magnitude = product < 0 ? -product : product;
    const Real s = size * size - 2 * magnitude; // gx^2 + gy^2, the same bits when transposed
    const Real square = s * s, guarded = square + gradient_guard<Real>;
    const Real c4 = square - 8 * (product * product);
    const Real s4 = 4 * product * ((gx - gy) * (gx + gy));
    const Real ratio = guarded / (guarded + eps * (c4 * cosine + s4 * sine)); // 1/xi
    return ratio * ratio;
  }
} // namespace melt
