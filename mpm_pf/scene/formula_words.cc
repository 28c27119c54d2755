#include "scene/formula_words.h"

namespace scene
{
  const std::vector<ExpressionWord> &expression_words()
  {
    static const std::vector<ExpressionWord> words{
        {"X", "X", "Where the material was at the start, in x; a length in the scene's unit."},
        {"Y", "Y", "Where the material was at the start, in y."},
        {"x", "x", "Where it is now, in x."},
        {"y", "y", "Where it is now, in y."},
        {"t", "t", "The time."},
        {"pi", "pi", "3.14159..."},
        {"?", "x < y ? 1 : 2", "The second value where the comparison holds, else the third."},
        {"smooth", "smooth(t, T)",
         "Rises from 0 at t = 0 to 1 at t = T with two continuous derivatives."},
        {"ramp", "ramp(t, T)",
         "The integral of smooth over the time: a displacement whose speed rises from 0 to 1 over "
         "T and stays; t - T/2 from T on."},
        {"sin", "sin(a)", "Sine, of radians."},
        {"cos", "cos(a)", "Cosine, of radians."},
        {"tan", "tan(a)", "Tangent, of radians."},
        {"asin", "asin(a)", "Arc sine, in radians."},
        {"acos", "acos(a)", "Arc cosine, in radians."},
        {"atan", "atan(a)", "Arc tangent, in radians."},
        {"sinh", "sinh(a)", "Hyperbolic sine."},
        {"cosh", "cosh(a)", "Hyperbolic cosine."},
        {"tanh", "tanh(a)", "Hyperbolic tangent."},
        {"exp", "exp(a)", "e to the power of a."},
        {"ln", "ln(a)", "Natural logarithm."},
        {"log10", "log10(a)", "Logarithm to the base 10."},
        {"sqrt", "sqrt(a)", "Square root."},
        {"abs", "abs(a)", "Absolute value."},
        {"min", "min(a, b)", "The smallest of two or more."},
        {"max", "max(a, b)", "The largest of two or more."},
        {"erf", "erf(a)", "Error function."},
        {"erfc", "erfc(a)", "1 - erf(a)."},
        {"E1", "E1(a)",
         "Exponential integral: that of exp(-s)/s over s from a to infinity, for a > 0."}};
    return words;
  }

  const std::vector<Quantity> &probe_quantities()
  {
    static const std::vector<Quantity> quantities{
        {"von_mises", "Equivalent stress of von Mises."},
        {"plastic_strain", "Equivalent plastic strain, summed up over the whole way."},
        {"pressure", "-(sigma_xx + sigma_yy + sigma_zz)/3."},
        {"stress_xx", "Cauchy stress on planes across x, along x."},
        {"stress_yy", "Cauchy stress on planes across y, along y."},
        {"stress_zz", "Cauchy stress out of the plane."},
        {"stress_xy", "Cauchy shear stress."},
        {"displacement_x", "Way since the start, in x."},
        {"displacement_y", "Way since the start, in y."},
        {"velocity_x", "Velocity in x, of the solid or of an imposed motion."},
        {"velocity_y", "Velocity in y, of the solid or of an imposed motion."},
        {"jacobian", "Present volume over that at the start."},
        {"yielded", "1 where the von Mises stress exceeds 0.99 of the yield stress, else 0; the "
                    "mean over a region is the yielded share."},
        {"log_strain_xx", "Logarithm of the left stretch since the start, component xx."},
        {"log_strain_yy", "Logarithm of the left stretch since the start, component yy."},
        {"area", "Present area of a material point or element; of a region the sum."},
        {"phi", "Phase field: 1 in the solid, -1 in the melt."},
        {"theta", "Temperature (T - Tm)/(L/cp)."},
        {"crystal_angle", "Angle of the crystal axes in radians, counter-clockwise."}};
    return quantities;
  }
} // namespace scene
