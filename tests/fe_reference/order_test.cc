// The manufactured solution in its hypoelastic form: order of the displacement in L2.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "small_scenes.h"

namespace
{
  // u_x = A sin(pi X), u_y = -A sin(pi Y) at full load; the static part of the body force is
  // b_x = pi^2 u_x (lambda + 2 mu) F_yy/(rho0 F_xx), since sigma = C : ln F and det F sigma F^-1
  // has the divergence -rho0 b. Returns the L2 error of the displacement.
  double error_on(const int cells, const int degree)
  {
    constexpr double A = 0.05, E = 1e7, nu = 0.3, density = 1000.;
    const double modulus = E * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
    scene::Scene scene = fe_test::solid_scene(E, {cells, cells}, degree, 4);
    scene.bodies = {fe_test::rectangle(0., 0., 1., 1.)};
    const std::string ux = "0.05*t*sin(pi*X)", uy = "-0.05*t*sin(pi*Y)";
    for (const scene::Edge edge :
         {scene::Edge::left, scene::Edge::right, scene::Edge::bottom, scene::Edge::top})
      scene.supports.push_back(fe_test::support("rim", edge, ux, uy));
    const std::string Fx = "(1 + 0.05*t*pi*cos(pi*X))", Fy = "(1 - 0.05*t*pi*cos(pi*Y))";
    const std::string factor = std::to_string(modulus / density) + "*pi^2*";
    scene.body_force.emplace();
    scene.body_force->acceleration = {
        fe_test::expression(factor + "(" + ux + ")*" + Fy + "/" + Fx),
        fe_test::expression(factor + "(" + uy + ")*" + Fx + "/" + Fy)};
    const fe::Problem problem = fe_test::problem_of(scene);
    const fe::Outcome outcome = fe_test::solve(scene, problem);
    EXPECT_EQ(outcome.kind, fe::Outcome::Kind::complete);

    const fe::Discretisation &d = problem.mesh;
    double squared = 0.;
    for (int cell = 0; cell < d.cells; ++cell)
      for (int q = 0; q < d.points_per_cell; ++q)
      {
        fe::Point X = fe::Point::Zero(), u = fe::Point::Zero();
        for (int a = 0; a < d.nodes_per_cell; ++a)
        {
          const int n = d.nodes_of(cell)[a];
          const double shape = d.shape[q * d.nodes_per_cell + a];
          X += shape * d.position[n];
          u += shape * fe::Point(outcome.last.u[2 * n], outcome.last.u[2 * n + 1]);
        }
        const fe::Point exact(A * std::sin(M_PI * X[0]), -A * std::sin(M_PI * X[1]));
        squared += d.weight[cell * d.points_per_cell + q] * (u - exact).squaredNorm();
      }
    return std::sqrt(squared);
  }
} // namespace

TEST(ManufacturedSolution, LinearElementsConvergeAtSecondOrder)
{
  const double coarse = error_on(8, 1), fine = error_on(16, 1);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
  EXPECT_LT(fine, 1e-3);
}

TEST(ManufacturedSolution, QuadraticElementsConvergeAtThirdOrder)
{
  const double coarse = error_on(4, 2), fine = error_on(8, 2);
  EXPECT_GT(std::log2(coarse / fine), 2.9);
  EXPECT_LT(fine, 5e-5);
}
