// One element: its tangent is the derivative of its forces, it does not resist rigid motions, and
// it passes the patch test.
#include <gtest/gtest.h>

#include <cmath>

#include "fe_reference/assembly.h"
#include "small_scenes.h"

namespace
{
  struct Patch
  {
    fe::Problem problem;
    fe::State old, now;
  };

  // One distorted cell of either degree, plastic.
  Patch make_patch(const int degree)
  {
    Patch patch;
    patch.problem.mesh =
        fe::discretise({{{0., 0.}, {1.1, 0.1}, {1., 0.9}, {-0.1, 1.}}, {{0, 1, 2, 3}}}, degree);
    patch.problem.material = fe::make_material(200., 0.3);
    patch.problem.material.yield_stress = 0.4;
    patch.problem.supports.is_held.assign(patch.problem.mesh.unknowns(), 0);
    const int points = patch.problem.mesh.cells * patch.problem.mesh.points_per_cell;
    patch.old.points.resize(points);
    patch.old.u.assign(patch.problem.mesh.unknowns(), 0.);
    patch.now = patch.old;
    patch.now.time = 0.1;
    return patch;
  }

  std::vector<double> forces(const Patch &patch, const std::vector<double> &u,
                             std::vector<double> *tangent = nullptr)
  {
    const fe::Discretisation &d = patch.problem.mesh;
    const int size = 2 * d.nodes_per_cell;
    std::vector<double> local(size), force(size);
    for (int k = 0; k < size; ++k)
      local[k] = u[2 * d.nodes_of(0)[k / 2] + k % 2];
    std::vector<fe::PointState> now(patch.old.points.size());
    if (tangent)
      tangent->resize(size * size);
    fe::evaluate_element(d.degree, patch.problem.material,
                         {d.gradient.data(), d.weight.data(), d.mode.data()},
                         {local.data(), patch.old.points.data(), now.data(), force.data(),
                          tangent ? tangent->data() : nullptr, 0.1});
    return force;
  }
} // namespace

class Element : public ::testing::TestWithParam<int>
{
};

TEST_P(Element, TangentIsTheDerivativeOfItsForces)
{
  const Patch patch = make_patch(GetParam());
  const fe::Discretisation &d = patch.problem.mesh;
  std::vector<double> u(d.unknowns());
  for (int n = 0; n < d.nodes; ++n)
  {
    const fe::Point &X = d.position[n];
    u[2 * n] = 0.05 * X[0] * X[1] + 0.1 * X[1];
    u[2 * n + 1] = -0.03 * X[0] * X[0] + 0.04 * X[1] * X[1] * X[0];
  }
  std::vector<double> tangent;
  forces(patch, u, &tangent);
  const int size = 2 * d.nodes_per_cell;
  constexpr double h = 1e-6;
  double error = 0., norm = 0.;
  for (int k = 0; k < size; ++k)
  {
    const int unknown = 2 * d.nodes_of(0)[k / 2] + k % 2;
    std::vector<double> plus = u, minus = u;
    plus[unknown] += h;
    minus[unknown] -= h;
    const std::vector<double> up = forces(patch, plus), down = forces(patch, minus);
    for (int i = 0; i < size; ++i)
    {
      error = std::max(error, std::abs((up[i] - down[i]) / (2. * h) - tangent[i * size + k]));
      norm = std::max(norm, std::abs(tangent[i * size + k]));
    }
  }
  EXPECT_LT(error, 1e-6 * norm);
}

TEST_P(Element, DoesNotResistARigidRotation)
{
  const Patch patch = make_patch(GetParam());
  const fe::Discretisation &d = patch.problem.mesh;
  std::vector<double> u(d.unknowns());
  for (int n = 0; n < d.nodes; ++n)
  {
    const fe::Point &X = d.position[n];
    u[2 * n] = (std::cos(1.) - 1.) * X[0] - std::sin(1.) * X[1] + 3.;
    u[2 * n + 1] = std::sin(1.) * X[0] + (std::cos(1.) - 1.) * X[1] - 2.;
  }
  for (const double force : forces(patch, u))
    EXPECT_NEAR(force, 0., 1e-12);
}

TEST_P(Element, ReportsAFoldedMesh)
{
  const Patch patch = make_patch(GetParam());
  const fe::Discretisation &d = patch.problem.mesh;
  fe::State now = patch.now;
  for (int n = 0; n < d.nodes; ++n)
    now.u[2 * n] = -2. * d.position[n][0]; // mirrored
  EXPECT_FALSE(fe::assemble(patch.problem, patch.old, now, nullptr));
  EXPECT_LT(now.smallest_jacobian, 0.);
}

TEST_P(Element, PassesThePatchTestOnADistortedMesh)
{
  // Four cells round an off-centre vertex, affine displacements of the rim: inside the same affine
  // field, one stress everywhere.
  const fe::QuadMesh mesh{
      {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1.2, 0.8}, {2., 1.}, {0., 2.}, {1., 2.}, {2., 2.}},
      {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}};
  scene::Scene scene = fe_test::solid_scene(200., {2, 2}, GetParam(), 2);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 2.)};
  const std::string x = "t*(0.1*X + 0.05*Y)", y = "t*(0.02*X - 0.08*Y)";
  for (const scene::Edge edge :
       {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
    scene.supports.push_back(fe_test::support("rim", edge, x, y));
  fe::Problem problem = fe_test::problem_of(scene);
  problem.mesh = fe::discretise(mesh, GetParam());
  problem.supports = fe::make_supports(scene, problem.mesh);
  const fe::Outcome outcome = fe_test::solve(scene, problem);
  ASSERT_EQ(outcome.kind, fe::Outcome::Kind::complete);
  const fe::Vector4 &stress = outcome.last.points.front().stress;
  EXPECT_GT(stress.norm(), 1.);
  for (const fe::PointState &point : outcome.last.points)
    EXPECT_LT((point.stress - stress).norm(), 1e-8 * stress.norm());
}

INSTANTIATE_TEST_SUITE_P(Degrees, Element, ::testing::Values(1, 2));
