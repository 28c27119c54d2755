// What probes report of the deformed body.
#include <gtest/gtest.h>

#include <cmath>

#include "fe_reference/patches.h"
#include "small_scenes.h"

namespace
{
  // A unit square stretched to (1 + 0.5) x 1 and shifted by 1 in x; every node driven.
  struct Stretched
  {
    scene::Scene scene;
    fe::Problem problem;
    fe::Outcome outcome;
  };

  Stretched stretched(const int degree)
  {
    Stretched s;
    s.scene = fe_test::solid_scene(1e6, {4, 4}, degree, 5);
    s.scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
    s.scene.supports = {
        fe_test::support("all", scene::Box{{0., 0.}, {1., 1.}}, "t*(1 + 0.5*X)", "0")};
    s.problem = fe_test::problem_of(s.scene);
    s.outcome = fe_test::solve(s.scene, s.problem);
    return s;
  }
} // namespace

class Probes : public ::testing::TestWithParam<int>
{
};

TEST_P(Probes, FindPointsInTheDeformedBodyAndMissThoseOutside)
{
  const Stretched s = stretched(GetParam());
  const fe::Snapshot body = fe::make_snapshot(s.problem, s.outcome.last, s.outcome.last);
  // x = 1.75 came from X = 0.5: displacement 1.25.
  const auto values = fe::values_at(body, {1.75, 0.3}, scene::Frame::current,
                                    {"displacement_x", "log_strain_xx", "jacobian"});
  EXPECT_NEAR(values[0], 1.25, 1e-12);
  EXPECT_NEAR(values[1], std::log(1.5), 1e-12);
  EXPECT_NEAR(values[2], 1.5, 1e-12);
  EXPECT_TRUE(
      std::isnan(fe::values_at(body, {0.9, 0.3}, scene::Frame::current, {"displacement_x"})[0]));
  EXPECT_NEAR(fe::values_at(body, {0.5, 0.3}, scene::Frame::material, {"displacement_x"})[0], 1.25,
              1e-12);
}

// Between the circle and the chord that the mesh makes of it there is material, and no cell.
TEST_P(Probes, FindMaterialPointsOnACurvedOutline)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {8, 8}, GetParam(), 2);
  scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
  scene.bodies[0].shape = scene::Disc{{0., 0.}, 1.};
  scene.supports = {
      fe_test::support("all", scene::Box{{-1., -1.}, {1., 1.}}, "t*(1 + 0.5*X)", "0")};
  const fe::Problem problem = fe_test::problem_of(scene);
  const fe::Outcome outcome = fe_test::solve(scene, problem);
  fe::Snapshot body = fe::make_snapshot(problem, outcome.last, outcome.last);
  body.starts_in = [](const fe::Point &X) { return X.norm() < 1. + 1e-9; };
  for (int k = 0; k < 100; ++k)
  {
    const fe::Point X(std::cos(0.0628 * k), std::sin(0.0628 * k));
    const auto at = [&](const double stretch)
    { return fe::values_at(body, stretch * X, scene::Frame::material, {"displacement_x"})[0]; };
    EXPECT_NEAR(at(1.), 1. + 0.5 * X[0], 0.01) << k;
    EXPECT_TRUE(std::isnan(at(1.001))) << k;
  }
}

TEST_P(Probes, LineSaysWhereThereIsNoMaterial)
{
  const Stretched s = stretched(GetParam());
  const fe::Snapshot body = fe::make_snapshot(s.problem, s.outcome.last, s.outcome.last);
  scene::LineProbe line;
  line.a = {0., 0.5};
  line.b = {3., 0.5};
  line.points = 7; // 0, 0.5, 1, 1.5, 2, 2.5, 3: material from 1 to 2.5
  const record::LineSample sample =
      fe::sample_line(body, line, {"stress_xx", "displacement_x"}, 0.1);
  ASSERT_EQ(sample.values.size(), 14u);
  for (int k = 0; k < 7; ++k)
  {
    const bool inside = k >= 2 && k <= 5;
    EXPECT_EQ(std::isnan(sample.values[2 * k]), !inside) << k;
    EXPECT_EQ(std::isnan(sample.values[2 * k + 1]), !inside) << k;
  }
  // Uniaxial logarithmic strain: (lambda + 2 mu) ln 1.5.
  const double modulus = s.problem.material.lame + 2. * s.problem.material.shear_modulus;
  EXPECT_NEAR(sample.values[6], modulus * std::log(1.5), 1e-6 * modulus);
}

namespace
{
  /// The end of the stretch, with a plastic strain that is the current x of its point.
  fe::Snapshot with_strain_linear_in_x(const Stretched &s)
  {
    fe::Snapshot body = fe::make_snapshot(s.problem, s.outcome.last, s.outcome.last);
    const fe::Discretisation &d = s.problem.mesh;
    for (int cell = 0; cell < d.cells; ++cell)
      for (int q = 0; q < d.points_per_cell; ++q)
        body.points[cell * d.points_per_cell + q].plastic_strain =
            fe::position_in(body, {cell, d.unit_point[q]}, scene::Frame::current)[0];
    return body;
  }
} // namespace

TEST_P(Probes, BinAveragesOverCurrentAreaWhateverTheMesh)
{
  // A field linear in x: the bin's mean is the value at its centre, away from the sides.
  Stretched s = stretched(GetParam());
  const fe::Snapshot body = with_strain_linear_in_x(s);
  scene::LineProbe line;
  line.a = {1.5, 0.5};
  line.b = {2., 0.5};
  line.points = 2;
  line.bin = 0.375; // one cell wide, so that whole patches are averaged
  line.a[0] = 1. + 0.375 * 1.5;
  line.b[0] = 1. + 0.375 * 2.5;
  const record::LineSample sample = fe::sample_line(body, line, {"plastic_strain"}, 1.);
  EXPECT_NEAR(sample.values[0], line.a[0], 1e-10);
  EXPECT_NEAR(sample.values[1], line.b[0], 1e-10);
}

TEST_P(Probes, APointAveragesOverItsBinAsALineDoes)
{
  Stretched s = stretched(GetParam());
  const fe::Snapshot body = with_strain_linear_in_x(s);
  const fe::Point centre(1. + 0.375 * 1.5, 0.5);
  scene::PointProbe point{centre, scene::Frame::current, 0.375};
  EXPECT_NEAR(fe::sample_point(body, point, {"plastic_strain"}, 1.)[0], centre[0], 1e-10);
  point.at[0] +=
      0.4 * 0.375; // most of the square is elsewhere than the patch that holds its centre
  const double here = fe::values_at(body, point.at, point.frame, {"plastic_strain"})[0];
  const double mean = fe::sample_point(body, point, {"plastic_strain"}, 1.)[0];
  EXPECT_LT(std::abs(mean - point.at[0]), 0.3 * 0.375) << "the centre";
  point.bin.reset();
  EXPECT_EQ(fe::sample_point(body, point, {"plastic_strain"}, 0.375)[0], mean) << "the default";
  EXPECT_EQ(fe::sample_point(body, point, {"plastic_strain"}, 1e-9)[0], here)
      << "a square that meets no sample";
}

TEST_P(Probes, RegionMeansAndOutlineAgreeOnTheArea)
{
  const Stretched s = stretched(GetParam());
  const fe::Snapshot body = fe::make_snapshot(s.problem, s.outcome.last, s.outcome.last);
  const auto means = fe::region_means(body, {}, {"area", "jacobian"});
  EXPECT_NEAR(means[0], 1.5, 1e-12);
  EXPECT_NEAR(means[1], 1.5, 1e-12);
  const auto curves = fe::outlines(body);
  ASSERT_EQ(curves.size(), 1u);
  double area = 0.;
  for (std::size_t k = 0; k < curves[0].size(); ++k)
  {
    const fe::Point &a = curves[0][k], &b = curves[0][(k + 1) % curves[0].size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(area, 1.5, 1e-12); // counter-clockwise: positive
  EXPECT_NEAR(fe::region_means(body, {scene::Box{{0., 0.}, {0.5, 1.}}}, {"area"})[0], 0.75, 1e-12);
}

TEST_P(Probes, SnapshotHoldsElementMeansOfEveryCell)
{
  const Stretched s = stretched(GetParam());
  const fe::Snapshot body = fe::make_snapshot(s.problem, s.outcome.last, s.outcome.last);
  const record::Snapshot snapshot = fe::cell_snapshot(body, {"jacobian", "area"});
  EXPECT_EQ(snapshot.kind, record::Snapshot::Kind::cells);
  EXPECT_EQ(snapshot.vertex.size(), 25u);
  EXPECT_EQ(snapshot.connectivity.size(), 64u);
  for (const double jacobian : snapshot.fields.at("jacobian"))
    EXPECT_NEAR(jacobian, 1.5, 1e-12);
  for (const double valid : snapshot.fields.at("valid"))
    EXPECT_EQ(valid, 1.);
}

TEST_P(Probes, FoldedCellsAreMarkedInvalid)
{
  Stretched s = stretched(GetParam());
  // Pull one corner node through its cell.
  for (int n = 0; n < s.problem.mesh.nodes; ++n)
    if (s.problem.mesh.position[n].norm() < 1e-9)
      s.outcome.last.u[2 * n] += 1.;
  double smallest = 1.;
  const std::vector<char> folded = fe::folded_cells(s.problem, s.outcome.last.u, smallest);
  EXPECT_EQ(std::count(folded.begin(), folded.end(), 1), 1);
  EXPECT_LT(smallest, 0.);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Probes, ::testing::Values(1, 2));
