// A run that its walls end early must still answer the probes that look at the end.

#include <gtest/gtest.h>

#include "record/reader.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  const std::string walled =
      "title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [32, 32]\n"
      "[[body]]\nshape = \"rectangle\"\ncorner = [4.0, 4.0]\nsize = [8.0, 8.0]\n"
      "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\ndensity = 1.0\n"
      "[phase_field]\nwidth = 1.0\n"
      "[[wall]]\nside = \"top\"\nspeed = 1.0\ntravel = 4.5\nstart_time = 0.0\n"
      "[[probe]]\nname = \"shape\"\noutline = \"material\"\n"
      "[[probe]]\nname = \"melt\"\nhistory = true\nevery = 2.0\n"
      "[clock]\nend = 9.0\n";
} // namespace

TEST(EarlyEnd, IsSeenOnceByProbesOfTheEndAndOfIntervals)
{
  const Scratch scratch;
  const scene::Scene scene = scene_of(walled);
  const std::string path = scratch / "record.h5";
  {
    World world = build_world(scene, 1);
    record::Writer writer(path, record::collect_provenance("test", "test", 1), scene, true);
    Recorder recorder(scene, writer);
    ASSERT_TRUE(simulate(world, recorder, [](const World &) { return true; }));
    EXPECT_LT(world.time, 4.7);
    writer.finish({});
  }
  const record::Reader reader(path);
  ASSERT_EQ(reader.outline("shape").time.size(), 1u);
  EXPECT_NEAR(reader.outline("shape").time[0], 4.5, 0.1);
  const auto times = reader.table("melt").time;
  ASSERT_EQ(times.size(), 4u); // 0, 2, 4 and the end
  EXPECT_NEAR(times.back(), 4.5, 0.1);
}

TEST(EarlyEnd, CompressionCountsFromTheFirstContactWithAndWithoutAPhaseField)
{
  std::string plain = walled;
  plain.erase(plain.find("[phase_field]"), std::string("[phase_field]\nwidth = 1.0\n").size());
  for (const std::string &text : {walled, plain})
  {
    const scene::Scene scene = scene_of(text);
    World world = build_world(scene, 1);
    EXPECT_DOUBLE_EQ(expected_end(world), 4.5); // before it starts, for --plan
    double foreseen = 0.;
    while (!finished(world))
    {
      step(world, coupling_step(world));
      if (foreseen == 0.)
        foreseen = expected_end(world);
      // The block's edge is 4 away from the wall; points feel a wall over two cells at most.
      const medium::Wall &wall = world.walls->walls[0];
      ASSERT_FALSE(wall.touched && wall.travel < 3.) << wall.travel;
    }
    EXPECT_NEAR(foreseen, world.time, 0.1);
    const double tenth_of_a_cell = 0.05; // what an edge on a grid line is felt to
    EXPECT_NEAR(medium::compression(*world.walls), 0.5 / 12., tenth_of_a_cell / 12.) << text;
  }
}

TEST(EarlyEnd, CompressionsAreSeenWhenTheyAreReached)
{
  const Scratch scratch;
  std::string text = walled;
  text.replace(text.find("every = 2.0"), 11, "compressions = [0.013, 0.031]");
  const scene::Scene scene = scene_of(text);
  World world = build_world(scene, 1);
  record::Writer writer(scratch / "record.h5", record::collect_provenance("test", "test", 1), scene,
                        true);
  Recorder recorder(scene, writer);
  double wanted = recorder.next_compression(), before = 0.;
  int seen = 0;
  ASSERT_TRUE(simulate(world, recorder,
                       [&](const World &w)
                       {
                         const double now = medium::compression(*w.walls);
                         if (recorder.next_compression() != wanted)
                         {
                           EXPECT_NEAR(now, wanted, 2e-3 * wanted) << "from " << before;
                           wanted = recorder.next_compression(), ++seen;
                         }
                         before = now;
                         return true;
                       }));
  EXPECT_EQ(seen, 2);
  writer.finish({});
}

TEST(EarlyEnd, AWallThatWouldStartAfterItIsRefused)
{
  std::string late = walled;
  late.replace(late.find("start_time = 0.0"), 16, "start_time = 9.0");
  try
  {
    scene_of(late);
    ADD_FAILURE() << "it was accepted";
  }
  catch (const scene::BadScene &refusal)
  {
    EXPECT_NE(std::string(refusal.what()).find("when the run has ended"), std::string::npos);
  }
}
