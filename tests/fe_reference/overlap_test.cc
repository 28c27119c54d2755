// Bodies in each other and in themselves.
#include <gtest/gtest.h>

#include "fe_reference/overlap.h"
#include "fe_reference/pieces.h"
#include "small_scenes.h"

namespace
{
  struct Body
  {
    fe::Discretisation mesh;
    std::vector<int> piece;
  };

  Body body(const scene::Scene &scene)
  {
    Body body;
    body.mesh = fe::discretise(fe::make_mesh(scene), scene.fe->degree);
    body.piece =
        fe::connected_pieces(body.mesh.nodes, body.mesh.cell_node, body.mesh.nodes_per_cell);
    return body;
  }

  // A block 2 x 0.5 on a base, and one 1 x 0.4 above it with a gap of 0.1.
  scene::Scene punch_above_block()
  {
    scene::Scene scene = fe_test::solid_scene(1e6, {20, 10}, 2, 10);
    scene.bodies = {fe_test::rectangle(0., 0., 2., 0.5), fe_test::rectangle(0.5, 0.6, 1., 0.4)};
    scene.supports = {fe_test::support("bottom", scene::Edge::bottom, "0", "0"),
                      fe_test::support("punch", scene::Box{{0.4, 0.9}, {1.6, 1.1}}, "0", "-0.4*t")};
    return scene;
  }

  std::vector<double> lowered(const fe::Discretisation &d, const double above, const double by)
  {
    std::vector<double> u(d.unknowns(), 0.);
    for (int n = 0; n < d.nodes; ++n)
      if (d.position[n][1] > above)
        u[2 * n + 1] = -by;
    return u;
  }
} // namespace

TEST(Overlap, OfPiecesBeginsWhereTheyMeet)
{
  const Body two = body(punch_above_block());
  EXPECT_FALSE(overlap_of_pieces(two.mesh, two.piece, lowered(two.mesh, 0.55, 0.)));
  EXPECT_FALSE(overlap_of_pieces(two.mesh, two.piece, lowered(two.mesh, 0.55, 0.1)));
  const auto where = overlap_of_pieces(two.mesh, two.piece, lowered(two.mesh, 0.55, 0.12));
  ASSERT_TRUE(where);
  EXPECT_NEAR((*where)[1], 0.5, 0.021);
}

TEST(Overlap, EndsTheMarchWithAWord)
{
  const scene::Scene scene = punch_above_block();
  const fe::Problem problem = fe_test::problem_of(scene);
  const std::vector<int> piece =
      fe::connected_pieces(problem.mesh.nodes, problem.mesh.cell_node, problem.mesh.nodes_per_cell);
  fe::LinearSystem system(problem.mesh);
  std::string overlap;
  fe::SteppingOptions options;
  options.end = 1.;
  options.load_steps = 10;
  options.observe = [&](const fe::Step &step)
  { overlap = overlap_of_pieces(problem.mesh, piece, step.state.u) ? "in each other" : ""; };
  options.interrupted = [] { return false; };
  options.refused = [&] { return overlap; };
  const fe::Outcome outcome =
      fe::run_load_steps(problem, system, fe::initial_state(problem, scene), options);
  EXPECT_EQ(outcome.kind, fe::Outcome::Kind::diverged);
  EXPECT_EQ(outcome.message, "in each other");
  EXPECT_NEAR(outcome.last.time, 0.3, 1e-9); // 0.12 of the gap of 0.1
}

// A horseshoe whose upper arm is laid through the lower one: one piece.
TEST(Overlap, WithItselfIsSeen)
{
  scene::Scene scene = fe_test::solid_scene(1e6, {20, 10}, 2, 1);
  scene.bodies = {fe_test::rectangle(0., 0., 2., 0.3), fe_test::rectangle(0., 0., 0.3, 1.),
                  fe_test::rectangle(0., 0.7, 2., 0.3)};
  scene.supports = {fe_test::support("left", scene::Edge::left, "0", "0")};
  const Body one = body(scene);
  const std::vector<char> folded(one.mesh.cells, 0);
  EXPECT_FALSE(overlap_with_itself(one.mesh, one.piece, lowered(one.mesh, 0.69, 0.), folded));
  std::vector<double> u = lowered(one.mesh, 0.69, 0.);
  for (int n = 0; n < one.mesh.nodes; ++n)
    if (one.mesh.position[n][1] > 0.69)
      u[2 * n + 1] = -0.3 * std::max(0., one.mesh.position[n][0] - 0.3); // 0.51 at its end
  EXPECT_TRUE(overlap_with_itself(one.mesh, one.piece, u, folded));
  EXPECT_FALSE(overlap_of_pieces(one.mesh, one.piece, u));
}
