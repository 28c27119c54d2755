// Kinematics of one load increment: rotation and logarithmic stretch, both exact, with derivatives.
//
// The material points integrate the Jaumann rate with the mid-step spin (Hughes and Winget). Here
// the increment f = dx_{n+1}/dx_n is split instead by its polar decomposition f = V R: the stress
// is turned by R and strained by ln V,
//
//     sigma_trial = R sigma_n R^T + C : ln V,
//
// which is exact for every rigid rotation below half a turn and for every stretch along fixed axes,
// and agrees with the Jaumann rate d(sigma)/dt = W sigma - sigma W + C : D to second order in the
// increment, because polar rotation and integrated spin differ by its third power only. In two
// dimensions both have closed forms: R turns by atan2(f21 - f12, f11 + f22), and with b = f f^T of
// mean m and radius r (Mohr),  ln V = (ln det f / 2) 1 + (atanh(r/m) / 2r) dev b,  whose
// coefficient is smooth through r = 0, so nothing divides by a difference of eigenvalues.
// Source: N. J. Higham, Functions of Matrices (2008), ch. 8 and 11; the two-dimensional forms are
// derived here.
#pragma once

#include <Eigen/Core>

namespace fe
{
  using Matrix2 = Eigen::Matrix2d;
  using Matrix4 = Eigen::Matrix4d;
  using Vector4 = Eigen::Vector4d;

  /// Components of a symmetric tensor in plane strain: xx, yy, zz, xy (not doubled).
  enum Component
  {
    xx,
    yy,
    zz,
    xy
  };

  /// Rotation and logarithmic stretch of an increment. Derivatives are with respect to the spatial
  /// velocity gradient l = df f^-1, components in the order l11, l12, l21, l22.
  struct Increment
  {
    double angle = 0.;                            // of R, radians, counter-clockwise
    Vector4 stretch = Vector4::Zero();            // ln V: xx, yy, zz = 0, xy
    Vector4 angle_derivative = Vector4::Zero();   // d angle / dl
    Matrix4 stretch_derivative = Matrix4::Zero(); // d stretch / dl
  };

  /// Polar rotation and logarithm of the left stretch of `f` (2x2, no unit, det f > 0 required).
  Increment decompose(const Matrix2 &f);

  /// Logarithm of the left stretch of `F` alone (xx, yy, 0, xy).
  Vector4 logarithmic_strain(const Matrix2 &F);

  /// R sigma R^T for a rotation by `angle` about z; zz stays.
  Vector4 rotate(const Vector4 &stress, double angle);

  /// d(R sigma R^T)/d angle, given the already rotated stress.
  Vector4 rotation_derivative(const Vector4 &rotated);
} // namespace fe
