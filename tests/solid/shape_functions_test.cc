#include <gtest/gtest.h>

#include "solid/shape_functions.h"

using solid::Fold;
using solid::Shape;
using solid::Weights;

namespace
{
  constexpr double dx = 0.25, lower = -1.;

  // Weights of a point at x with node j nearest; s in [-1/2, 1/2].
  Weights at(const Shape shape, const double s)
  {
    switch (shape)
    {
    case Shape::quadratic_bspline:
      return solid::weights<Shape::quadratic_bspline>(s, dx, 1. / dx, 0.25);
    case Shape::ugimp:
      return solid::weights<Shape::ugimp>(s, dx, 1. / dx, 0.25);
    default:
      return solid::weights<Shape::linear>(s, dx, 1. / dx, 0.25);
    }
  }

  void expect_consistent(const Weights &w)
  {
    EXPECT_NEAR(w.w[0] + w.w[1] + w.w[2], 1., 1e-14);
    EXPECT_NEAR(w.g[0] + w.g[1] + w.g[2], 0., 1e-13);
    double first = 0., slope = 0.;
    for (int k = 0; k < 3; ++k)
      first += w.w[k] * w.d[k], slope += w.g[k] * w.d[k];
    EXPECT_NEAR(first, 0., 1e-14); // the point is where its nodes say
    EXPECT_NEAR(slope, 1., 1e-13);
  }

  constexpr Shape shapes[] = {Shape::quadratic_bspline, Shape::ugimp, Shape::linear};
} // namespace

TEST(ShapeFunctions, SumToOneAndReproduceLinearFields)
{
  for (const Shape shape : shapes)
    for (int k = 0; k <= 100; ++k)
      expect_consistent(at(shape, -0.5 + 0.01 * k));
}

TEST(ShapeFunctions, UniformGimpIsTheMeanOfHatsOverThePoint)
{
  const double l = 0.25, s = 0.1; // cells; the branch that crosses the node
  EXPECT_NEAR(at(Shape::ugimp, s).w[1], 1. - (s * s + l * l) / (2. * l), 1e-14);
  EXPECT_NEAR(at(Shape::ugimp, 0.4).w[2], 0.4, 1e-14); // inside one hat
}

TEST(ShapeFunctions, FoldedOnesSumToOneReproduceLinearFieldsAndAreNotNegative)
{
  for (const Shape shape : shapes)
    for (const int side : {1, -1})
      for (int position = 0; position < 40; ++position)
      {
        const double line = lower + (5. + position / 40.) * dx;
        const Fold fold = solid::fold_at(line, side, lower, dx);
        for (int k = 0; k < 60; ++k)
        {
          const double x = line + side * k / 40. * dx, cells = (x - lower) / dx;
          const int nearest = static_cast<int>(std::floor(cells + 0.5));
          if (nearest != fold.master && nearest != fold.carrier())
            continue;
          Weights w = at(shape, cells - nearest);
          solid::apply(fold, nearest, x, lower, dx, w);
          expect_consistent(w);
          for (const double weight : w.w)
            EXPECT_GE(weight, -1e-14);
        }
      }
}

TEST(ShapeFunctions, OnTheLineOnlyTheCarrierCounts)
{
  for (const double offset : {0., 0.2, 0.49, 0.51, 0.8})
  {
    const double line = lower + (5. + offset) * dx;
    const Fold fold = solid::fold_at(line, 1, lower, dx);
    const int nearest = static_cast<int>(std::floor(5. + offset + 0.5));
    Weights w = at(Shape::quadratic_bspline, 5. + offset - nearest);
    solid::apply(fold, nearest, line, lower, dx, w);
    EXPECT_NEAR(w.w[fold.carrier() - nearest + 1], 1., 1e-13) << offset;
  }
}

TEST(ShapeFunctions, ALineOnTheGridGivesTheInterpolatingSpline)
{
  const Fold fold = solid::fold_at(lower + 5. * dx, 1, lower, dx);
  const double s = 0.3;
  Weights w = at(Shape::quadratic_bspline, s);
  solid::apply(fold, 5, lower + (5. + s) * dx, lower, dx, w);
  EXPECT_NEAR(w.w[0], 0., 1e-15);
  EXPECT_NEAR(w.w[1], 1. - s, 1e-14); // N0 + 2 N-1
  EXPECT_NEAR(w.w[2], s, 1e-14);      // N1 - N-1
}

// Two walls that come from both sides fold the same rows in the same step, also where each is
// half-way between two rows, however that is rounded: 32.4 is 90.5 cells of 0.8 from -40.
TEST(Fold, OfALineAndOfItsMirrorImageAreMirrorImages)
{
  const double lower = -40., dx = 0.8;
  for (const double y : {33.6, 33.2, 32.9, 32.4, 32.4 + 1e-14, 32.4 - 1e-14, 31.6, 0.4})
  {
    const solid::Fold top = solid::fold_at(y, -1, lower, dx);
    const solid::Fold bottom = solid::fold_at(-y, 1, lower, dx);
    EXPECT_EQ(top.master, 100 - bottom.master) << y;
  }
}
