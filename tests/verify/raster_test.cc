// Means over squares against integrals done by hand, of points, nodes and cells.
#include "raster.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "judge.h"
#include "norm.h"
#include "workspace.h"

using namespace verify;

namespace
{
  using Kind = record::Snapshot::Kind;

  /// f = x + 3 y^2: its mean over a square is that at the centre, and b^2/4 more.
  double field(const scene::Point &p)
  {
    return p[0] + 3. * p[1] * p[1];
  }
  double mean_over(const std::array<int, 2> &square, const double b)
  {
    const scene::Point centre((square[0] + 0.5) * b, (square[1] + 0.5) * b);
    return field(centre) + b * b / 4.;
  }

  /// A body [0.5, 3] x [-1, 2] in n pieces to the unit of length.
  record::Snapshot points(const int n)
  {
    record::Snapshot all;
    const double h = 1. / n;
    for (int j = -n; j < 2 * n; ++j)
      for (int i = n / 2; i < 3 * n; ++i)
      {
        all.vertex.emplace_back((i + 0.5) * h, (j + 0.5) * h);
        all.fields["area"].push_back(h * h);
        all.fields["f"].push_back(field(all.vertex.back()));
      }
    return all;
  }
  /// The same of quadrilaterals that are no rectangles: inner vertices are moved.
  record::Snapshot cells(const int n)
  {
    record::Snapshot all;
    all.kind = Kind::cells;
    const int columns = 3 * n - n / 2, rows = 3 * n;
    const double h = 1. / n;
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i)
      {
        const bool inner = i > 0 && i < columns && j > 0 && j < rows;
        const double shift = inner ? 0.2 * h * ((i + j) % 2 == 0 ? 1. : -1.) : 0.;
        all.vertex.emplace_back(0.5 + i * h + shift, -1. + j * h - shift);
      }
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
      {
        const int a = j * (columns + 1) + i, b = a + columns + 1;
        for (const int corner : {a, a + 1, b + 1, b})
          all.connectivity.push_back(corner);
      }
    for (const scene::Point &p : places(all))
      all.fields["f"].push_back(field(p));
    return all;
  }

  Raster raster_of(const record::Snapshot &snapshot, const double bin,
                   const std::string &mirror = "")
  {
    std::vector<std::size_t> all(snapshot.fields.at("f").size());
    std::iota(all.begin(), all.end(), 0u);
    return rasterised(snapshot, {all, snapshot.fields.at("f")}, bin, mirror);
  }
} // namespace

// Squares of 1: the body fills two columns of three rows and half of the column before them.
TEST(Rasters, OfPointsAreMeansOverFilledSquares)
{
  const Raster raster = raster_of(points(20), 1.);
  ASSERT_EQ(raster.mean.size(), 6u);
  for (const auto &[square, mean] : raster.mean)
  {
    EXPECT_GE(square[0], 1);
    EXPECT_NEAR(mean, mean_over(square, 1.), 1e-3) << square[0] << ' ' << square[1];
  }
}

TEST(Rasters, OfCellsCountAsMuchOfEachAsLiesInTheSquare)
{
  // 10 cells to a square; and cells of more than a square, which hold the value of their centre
  for (const auto &[square, mean] : raster_of(cells(10), 1.).mean)
    EXPECT_NEAR(mean, mean_over(square, 1.), 0.02) << square[0] << ' ' << square[1];
  record::Snapshot one;
  one.kind = Kind::cells;
  one.vertex = {{0., 0.}, {2., 0.}, {2., 1.}, {0., 1.}, {3., 0.}, {3., 1.}};
  one.connectivity = {0, 1, 2, 3, 1, 4, 5, 2};
  one.fields["f"] = {4., 7.};
  const Raster fine = raster_of(one, 0.8);
  EXPECT_NEAR(fine.mean.at({0, 0}), 4., 1e-12);
  EXPECT_NEAR(fine.mean.at({2, 0}), (0.4 * 4. + 0.4 * 7.) / 0.8, 0.05 * 3.); // cut at x = 2
}

TEST(Rasters, OfTwoProgramsAreComparedSquareBySquare)
{
  const Raster a = raster_of(points(20), 0.5), b = raster_of(cells(20), 0.5);
  EXPECT_LT(distance({"max", {}, 0.9}, a, b, b), 0.01);
  Raster moved = b;
  moved.mean.begin()->second += 0.3;
  EXPECT_NEAR(distance({"max", {}, 0.9}, moved, b, b), 0.3, 1e-12);
  EXPECT_NEAR(distance({"rms", {}, 0.9}, moved, b, b),
              0.3 / std::sqrt(static_cast<double>(b.mean.size())), 1e-12);
  moved.mean.erase(moved.mean.begin(), std::next(moved.mean.begin(), 10));
  EXPECT_THROW(distance({"rms", {}, 0.9}, moved, b, b), MissingData);
  EXPECT_NO_THROW(distance({"rms", {}, 0.5}, moved, b, b));
  EXPECT_THROW(distance({"rms", {}, 0.9}, a, 1., 1.), MissingData);
}

// Values belong to the places that were taken, not to the first ones of the snapshot.
TEST(Rasters, OfSomePlacesAreThoseOfTheWholeThere)
{
  for (const record::Snapshot &body : {points(20), cells(20)})
  {
    std::vector<std::size_t> upper;
    std::vector<double> values;
    const auto where = places(body);
    for (std::size_t i = 0; i < where.size(); ++i)
      if (where[i][1] > 1.)
      {
        upper.push_back(i);
        values.push_back(body.fields.at("f")[i]);
      }
    const Raster part = rasterised(body, {upper, values}, 0.5, ""), whole = raster_of(body, 0.5);
    ASSERT_EQ(part.mean.size(), 10u); // five columns of two rows
    for (const auto &[square, mean] : part.mean)
      EXPECT_NEAR(mean, whole.mean.at(square), 0.1) << square[0] << ' ' << square[1];
  }
}

TEST(Rasters, AreMirroredAboutTheAxes)
{
  const Raster straight = raster_of(points(20), 0.5);
  const Raster mirrored_x = raster_of(points(20), 0.5, "x"),
               mirrored_y = raster_of(points(20), 0.5, "y");
  ASSERT_EQ(mirrored_x.mean.size(), straight.mean.size());
  for (const auto &[square, mean] : straight.mean)
  {
    EXPECT_NEAR(mirrored_x.mean.at({-square[0] - 1, square[1]}), mean, 1e-12);
    EXPECT_NEAR(mirrored_y.mean.at({square[0], -square[1] - 1}), mean, 1e-12);
  }
}

TEST(Rasters, SayWhatTheyCannotBeMadeOf)
{
  record::Snapshot bare = points(4);
  EXPECT_THROW(raster_of(bare, 0.), MissingData);
  EXPECT_THROW(raster_of(bare, 10.), MissingData); // fills no square
  bare.fields.erase("area");
  EXPECT_THROW(raster_of(bare, 1.), MissingData);
}

TEST(Rasters, OfExpectTomlAreReadAndRefused)
{
  const Workspace workspace;
  const auto said = [&](const std::string &keys, const std::string &norm)
  {
    return workspace.said_of(
        "title = \"bar\"\n[[run]]\nsolver = \"mpm_pf\"\n[[check]]\nname = \"c\"\n"
        "take = {run = \"mpm_pf\", snapshot = \"s\", of = \"u\", " +
        keys + "}\nagainst = {snapshot = \"other\"}\nnorm = \"" + norm +
        "\"\nlimit = 0.1\nsource = \"s\"\nreason = \"r\"\n");
  };
  EXPECT_EQ(said("bin = \"0.5\"", "rms"), "");
  EXPECT_EQ(said("bin = \"0.5\", mirror = \"x\"", "relative_max"), "");
  const auto says = [&](const std::string &keys, const std::string &norm, const std::string &words)
  {
    const std::string message = said(keys, norm);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says("bin = \"0.5\", reduce = \"max\"", "rms", "and not both");
  says("box = [[0, 0], [1, 1]]", "rms", "and not both");
  says("reduce = \"max\", mirror = \"x\"", "absolute", "`mirror` says nothing about a number");
  says("bin = \"0.5\", mirror = \"z\"", "rms", "no such mirror");
  says("bin = \"0.5\"", "absolute", "the take is a raster");
  says("bin = \"0.5\"", "relative_l2", "the take is a raster");
}
