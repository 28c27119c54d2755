// When walls start, how they come up to speed, and when they have touched.
#include "tall_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

namespace medium
{
  TEST(Walls, WithAContactRampStopAtTheFrontAndStartOnceMoreFromRest)
  {
    const Mesh mesh = tall_mesh(8, 100); // 40 high
    scene::Wall asked;
    asked.side = Edge::top, asked.speed = 0.5, asked.travel = 20., asked.ramp = 4.;
    asked.contact_ramp = 8.;
    asked.start_distance = 8.;
    Walls walls = make_walls({asked}, mesh);
    Field<double> phi(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        phi(i, j) = std::tanh((33. - 0.4 * j) / std::sqrt(2.));
    const Wall &wall = walls.walls[0];
    double fastest_before = 0., speed = 0.;
    for (int step = 0; step < 2000 && wall.travel < asked.travel; ++step)
    {
      const bool touched_before = wall.touched.has_value();
      fill_behind(phi, walls.cuts, mesh);
      start_walls(walls, phi, mesh, 0.05 * step);
      move(walls, 0.05 * step, 0.05, mesh);
      update_cuts(walls, mesh, {{&phi, nullptr, nullptr}});
      if (!wall.touched)
        fastest_before = std::max(fastest_before, -wall.velocity);
      else if (!touched_before)
      {
        EXPECT_LT(-wall.velocity, 1e-4 * asked.speed) << "it starts from rest";
      }
      else
      {
        EXPECT_LE(std::abs(-wall.velocity - speed), 0.5 * 1.5 / 8. * 0.05 + 1e-9);
      }
      speed = -wall.velocity;
    }
    EXPECT_NEAR(fastest_before, asked.speed, 1e-12);
    ASSERT_TRUE(wall.touched);
    EXPECT_NEAR(wall.travel, asked.travel, 1e-12);
    EXPECT_NEAR(wall.travel_at_touch, 7., 0.4);
  }

  // A crystal may melt away after its wall has moved: the look for it ends with the mesh.
  TEST(Walls, LookForTheFrontNoFurtherThanTheMeshReaches)
  {
    const Mesh mesh = tall_mesh(8, 60); // 24 high
    scene::Wall asked;
    asked.side = Edge::top, asked.speed = 1., asked.travel = 8., asked.start_time = 0.;
    Walls walls = make_walls({asked}, mesh);
    Field<double> phi(mesh, -1.);
    for (int step = 0; step < 300; ++step)
    {
      start_walls(walls, phi, mesh, 0.03 * step);
      move(walls, 0.03 * step, 0.03, mesh);
      update_cuts(walls, mesh, {});
    }
    for (int j = -ghost_layers; j < 0; ++j) // where nothing is to be read
      for (int i = 0; i < mesh.nodes[0]; ++i)
        phi(i, j) = 1.;
    EXPECT_FALSE(gap_to_front(walls.walls[0], walls.cuts, phi, mesh, 100.));
    for (int i = 0; i < mesh.nodes[0]; ++i)
      phi(i, 0) = 1.; // the last line that is there: a front between it and the one before
    const auto gap = gap_to_front(walls.walls[0], walls.cuts, phi, mesh, 100.);
    ASSERT_TRUE(gap);
    EXPECT_NEAR(*gap, 16. - 0.2, 0.4);
  }

  TEST(Walls, StartAtADistanceBelowACell)
  {
    const Mesh mesh = tall_mesh(8, 100);
    scene::Wall asked;
    asked.side = Edge::top, asked.speed = 0.5, asked.travel = 20., asked.start_distance = 0.1;
    Walls walls = make_walls({asked}, mesh);
    Field<double> phi(mesh);
    double front = 39.;
    for (; !walls.walls[0].started && front < 40.; front += 0.01)
    {
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          phi(i, j) = std::tanh((front - 0.4 * j) / std::sqrt(2.));
      start_walls(walls, phi, mesh, front);
    }
    EXPECT_NEAR(40. - front, 0.1, 0.06); // the wall's own line sees phi = 0 by a parabola
  }

  TEST(Walls, PushedBeforeTheirTimeWaitForIt)
  {
    const Mesh mesh = tall_mesh(8, 100);
    scene::Wall asked;
    asked.side = Edge::top, asked.speed = 0.5, asked.travel = 20.;
    asked.start_time = 2., asked.contact_ramp = 0.2;
    Walls walls = make_walls({asked}, mesh);
    for (int step = 0; step < 60; ++step)
    {
      const double time = 0.05 * step;
      start_walls(walls, time);
      if (step == 10)
        record_contact(walls.walls[0], walls, mesh, time);
      move(walls, time, 0.05, mesh);
      const double now = time + 0.05;
      EXPECT_NEAR(walls.walls[0].travel, now <= 2. ? 0. : 0.5 * (now - 2.), 0.5 * 0.1 + 1e-12)
          << "at " << now;
      if (now <= 2.)
      {
        EXPECT_EQ(walls.walls[0].travel, 0.);
      }
      update_cuts(walls, mesh, {});
    }
    EXPECT_NEAR(walls.walls[0].travel, 0.5 * (3. - 2. - 0.1), 1e-9);
  }

  TEST(Walls, StartNearTheFrontRampUpAndNoteTheFirstContact)
  {
    const Mesh mesh = tall_mesh(8, 100); // 40 high
    scene::Wall asked;
    asked.side = Edge::top, asked.speed = 0.5, asked.travel = 20., asked.ramp = 4.;
    asked.start_distance = 8.;
    Walls walls = make_walls({asked}, mesh);
    Field<double> phi(mesh);
    double touched_position = 0., before = 0.;
    for (int step = 0; step < 2000; ++step)
    {
      const double time = 0.05 * step, front = 25. + 0.2 * time; // rises with 0.2
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          phi(i, j) = std::tanh((front - 0.4 * j) / std::sqrt(2.));
      fill_behind(phi, walls.cuts, mesh);
      const Wall &wall = walls.walls[0];
      const bool was_at_rest = !wall.started;
      start_walls(walls, phi, mesh, time);
      if (was_at_rest && wall.started)
      {
        EXPECT_NEAR(front, 32., 0.02);
      }
      if (wall.touched && touched_position == 0.)
        touched_position = wall.position - front;
      move(walls, time, 0.05, mesh);
      update_cuts(walls, mesh, {});
      if (wall.travel >= asked.travel)
        break;
      EXPECT_LE(-wall.velocity, 0.5 + 1e-12);
      EXPECT_LE(std::abs(wall.velocity - before), 0.5 * 1.5 / 4. * 0.05 + 1e-9); // smooth ramp
      before = wall.velocity;
    }
    EXPECT_NEAR(touched_position, 0., 0.4);
    const Wall &wall = walls.walls[0];
    EXPECT_NEAR(compression(walls), (20. - wall.travel_at_touch) / (40. - wall.travel_at_touch),
                1e-12);
    EXPECT_GT(wall.travel_at_touch, 1.);

    Walls resumed = make_walls({asked}, mesh);
    unpack(resumed, pack(walls));
    EXPECT_EQ(pack(resumed), pack(walls));
  }
} // namespace medium
