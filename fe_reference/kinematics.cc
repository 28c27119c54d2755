#include "kinematics.h"

#include <cmath>

namespace fe
{
  namespace
  {
    // h(q) = atanh(sqrt q)/sqrt q and its derivative, for 0 <= q < 1.
    struct Atanhc
    {
      double value, slope;
    };

    Atanhc atanhc(const double q)
    {
      if (q > 0.02)
      {
        const double root = std::sqrt(q);
        const double value = std::atanh(root) / root;
        return {value, (1. / (1. - q) - value) / (2. * q)};
      }
      // 1 + q/3 + q^2/5 + ...: ten terms are exact to rounding below q = 0.02.
      Atanhc sum{0., 0.};
      for (int k = 10; k >= 0; --k)
      {
        sum.value = sum.value * q + 1. / (2 * k + 1);
        if (k > 0)
          sum.slope = sum.slope * q + static_cast<double>(k) / (2 * k + 1);
      }
      return sum;
    }

    struct Stretch
    {
      double mean, half_difference, shear, ratio_squared; // Mohr's circle of b = f f^T
      double coefficient;                                 // atanh(r/m)/(2r)
      double slope;                                       // h'(q)/(2m)
      double log_determinant;
    };

    Stretch stretch_of(const Matrix2 &f)
    {
      const Matrix2 b = f * f.transpose();
      Stretch s{};
      s.mean = 0.5 * (b(0, 0) + b(1, 1));
      s.half_difference = 0.5 * (b(0, 0) - b(1, 1));
      s.shear = b(0, 1);
      s.ratio_squared =
          (s.half_difference * s.half_difference + s.shear * s.shear) / (s.mean * s.mean);
      const Atanhc h = atanhc(s.ratio_squared);
      s.coefficient = h.value / (2. * s.mean);
      s.slope = h.slope / (2. * s.mean);
      s.log_determinant = std::log(f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0));
      return s;
    }

    Vector4 logarithm(const Stretch &s)
    {
      const double mean = 0.5 * s.log_determinant;
      const double deviator = s.coefficient * s.half_difference;
      return {mean + deviator, mean - deviator, 0., s.coefficient * s.shear};
    }

    // db = l b + b l^T in terms of l11, l12, l21, l22: rows db11, db22, db12.
    Eigen::Matrix<double, 3, 4> derivative_of_b(const Stretch &s)
    {
      const double b11 = s.mean + s.half_difference, b22 = s.mean - s.half_difference,
                   b12 = s.shear;
      Eigen::Matrix<double, 3, 4> d;
      d << 2. * b11, 2. * b12, 0., 0., //
          0., 0., 2. * b12, 2. * b22,  //
          b12, b22, b11, b12;
      return d;
    }
  } // namespace

  Increment decompose(const Matrix2 &f)
  {
    const Stretch s = stretch_of(f);
    Increment increment;
    increment.stretch = logarithm(s);

    const double cosine = f(0, 0) + f(1, 1), sine = f(1, 0) - f(0, 1);
    increment.angle = std::atan2(sine, cosine);
    // df = l f, hence d(cosine) and d(sine) in the four components of l.
    const Vector4 dcosine(f(0, 0), f(1, 0), f(0, 1), f(1, 1));
    const Vector4 dsine(-f(0, 1), -f(1, 1), f(0, 0), f(1, 0));
    increment.angle_derivative =
        (cosine * dsine - sine * dcosine) / (cosine * cosine + sine * sine);

    using Row = Eigen::Matrix<double, 1, 4>;
    const Eigen::Matrix<double, 3, 4> db = derivative_of_b(s);
    const Row dmean = 0.5 * (db.row(0) + db.row(1));
    const Row dhalf = 0.5 * (db.row(0) - db.row(1));
    const Row dshear = db.row(2);
    const Row dratio = (2. / (s.mean * s.mean)) * (s.half_difference * dhalf + s.shear * dshear) -
                       (2. * s.ratio_squared / s.mean) * dmean;
    const Row dcoefficient = s.slope * dratio - (s.coefficient / s.mean) * dmean;
    const Row dlog(0.5, 0., 0., 0.5); // d(ln det f)/2 = tr l / 2
    const Row ddeviator = s.coefficient * dhalf + s.half_difference * dcoefficient;
    increment.stretch_derivative.row(xx) = dlog + ddeviator;
    increment.stretch_derivative.row(yy) = dlog - ddeviator;
    increment.stretch_derivative.row(xy) = s.coefficient * dshear + s.shear * dcoefficient;
    return increment;
  }

  Vector4 logarithmic_strain(const Matrix2 &F)
  {
    return logarithm(stretch_of(F));
  }

  Vector4 rotate(const Vector4 &stress, const double angle)
  {
    // Mohr's circle turns by twice the angle.
    const double c = std::cos(2. * angle), s = std::sin(2. * angle);
    const double mean = 0.5 * (stress[xx] + stress[yy]), half = 0.5 * (stress[xx] - stress[yy]);
    const double turned = half * c - stress[xy] * s;
    return {mean + turned, mean - turned, stress[zz], half * s + stress[xy] * c};
  }

  Vector4 rotation_derivative(const Vector4 &rotated)
  {
    return {-2. * rotated[xy], 2. * rotated[xy], 0., rotated[xx] - rotated[yy]};
  }
} // namespace fe
