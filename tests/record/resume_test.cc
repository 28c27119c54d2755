// A run that was killed goes on as if it had not been: checkpoint and record together.
#include <cmath>
#include <cstring>
#include <limits>

#include "../scratch.h"
#include "record/checkpoint.h"
#include "record/reader.h"
#include "record/writer.h"

namespace
{
  using namespace record;

  scene::Scene scene_of_hash(const std::string &hash)
  {
    scene::Scene scene;
    scene.file = "scene.toml";
    scene.hash = hash;
    return scene;
  }

  /// All that a run from `first` to `last` (steps) observes.
  void observe(Writer &writer, const int first, const int last)
  {
    for (int k = first; k <= last; ++k)
    {
      const double t = 0.1 * k;
      writer.table("energy", {{"kinetic"}, {"J"}}, t, {std::sin(t)});
      writer.line("line", {{"phi"}, {"1"}}, t, {{{t, 0.}, {1., t}}, {std::cos(t), t}});
      writer.outline("contour", t, {{{0., 0.}, {t, 0.}, {0., t}}});
      Snapshot cloud;
      cloud.vertex = {{t, t}};
      cloud.fields["jacobian"] = {t};
      writer.snapshot("fields", t, cloud);
    }
  }

  void expect_equal(const Reader &a, const Reader &b)
  {
    EXPECT_EQ(a.table("energy").time, b.table("energy").time);
    EXPECT_EQ(a.table("energy").rows, b.table("energy").rows);
    EXPECT_EQ(a.line("line").time, b.line("line").time);
    for (std::size_t k = 0; k < a.line("line").samples.size(); ++k)
    {
      EXPECT_EQ(a.line("line").samples[k].position, b.line("line").samples[k].position);
      EXPECT_EQ(a.line("line").samples[k].values, b.line("line").samples[k].values);
    }
    EXPECT_EQ(a.outline("contour").time, b.outline("contour").time);
    EXPECT_EQ(a.outline("contour").outlines, b.outline("contour").outlines);
    ASSERT_EQ(a.snapshot_times("fields"), b.snapshot_times("fields"));
    EXPECT_EQ(a.snapshot("fields", 14).vertex, b.snapshot("fields", 14).vertex);
  }
} // namespace

TEST(ResumedRecord, EqualsAnUninterruptedOne)
{
  const Scratch scratch;
  const scene::Scene scene = scene_of_hash("1");
  {
    Writer writer(scratch / "whole.h5", {}, scene, false);
    observe(writer, 0, 20);
    writer.finish({});
  }
  {
    Writer writer(scratch / "killed.h5", {}, scene, false);
    observe(writer, 0, 14); // the last checkpoint was after step 11
  }
  {
    Writer writer(scratch / "killed.h5", {}, scene, Writer::Resume{0.1 * 11});
    observe(writer, 12, 20);
    writer.finish({});
  }
  expect_equal(Reader(scratch / "killed.h5"), Reader(scratch / "whole.h5"));
  EXPECT_NE(Reader(scratch / "killed.h5").attribute("resumed").find("at t = 1.1"),
            std::string::npos);
}

// Killed before its first checkpoint, the second run would go on from that of the first: without
// what the first alone has recorded.
TEST(NewRecord, LeavesNoCheckpointOfAnEarlierRun)
{
  const Scratch scratch;
  const std::string path = scratch / "run.v2.h5", checkpoint = scratch / "run.v2.checkpoint.h5";
  const scene::Scene scene = scene_of_hash("1");
  {
    Writer interrupted(path, {}, scene, false);
    observe(interrupted, 0, 4);
    EXPECT_EQ(checkpoint_path(path), checkpoint);
    CheckpointFile(checkpoint, scene).finish();
  }
  {
    const Writer resumed(path, {}, scene, Writer::Resume{0.4});
    EXPECT_TRUE(std::filesystem::exists(checkpoint));
  }
  {
    const Writer afresh(path, {}, scene, false);
    EXPECT_FALSE(std::filesystem::exists(checkpoint));
  }
}

// Refused, it has replaced nothing: both still belong together.
TEST(NewRecord, KeepsTheCheckpointWhereItIsRefused)
{
  const Scratch scratch;
  const scene::Scene scene = scene_of_hash("1");
  Writer(scratch / "run.h5", {}, scene, false).finish({});
  const Writer forced(scratch / "run.h5", {}, scene, true);
  CheckpointFile(scratch / "run.checkpoint.h5", scene).finish();
  EXPECT_THROW(Writer(scratch / "run.h5", {}, scene, false), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(scratch / "run.checkpoint.h5"));
}

TEST(ResumedRecord, DropsLateRowsOfWindowsThatItHasAlready)
{
  // A mean over a window of +-1 about t = 2 comes at t = 3, after the checkpoint at 2.5.
  const Scratch scratch;
  const Columns column{{"force_x"}, {"N"}};
  {
    Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), false);
    writer.table("reaction", column, 1., {10.});
    writer.flush(); // the checkpoint
    writer.table("reaction", column, 2., {20.});
    writer.table("reaction", column, 3., {30.});
  }
  Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), Writer::Resume{2.5});
  for (int k = 2; k <= 4; ++k)
    writer.table("reaction", column, k, {10. * k});
  writer.finish({});
  EXPECT_EQ(Reader(scratch / "a.h5").table("reaction").time, (std::vector<double>{1., 2., 3., 4.}));
}

TEST(ResumedRecord, KeepsTheColumnsDeclaredBefore)
{
  const Scratch scratch;
  {
    Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), false);
    observe(writer, 0, 3);
  }
  Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), Writer::Resume{0.2});
  EXPECT_THROW(writer.table("energy", {{"elastic"}, {"J"}}, 1., {0.}), std::invalid_argument);
  EXPECT_THROW(writer.line("line", {{"phi"}, {"1"}}, 1., {{{0., 0.}}, {0.}}),
               std::invalid_argument);
}

TEST(ResumedRecord, RefusesAnotherSceneOrNoRecord)
{
  const Scratch scratch;
  EXPECT_NE(error_of<std::runtime_error>(
                [&] { Writer(scratch / "a.h5", {}, scene_of_hash("1"), Writer::Resume{0.}); })
                .find("--resume"),
            std::string::npos);
  {
    Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), false);
  }
  EXPECT_NE(error_of<std::runtime_error>(
                [&] { Writer(scratch / "a.h5", {}, scene_of_hash("2"), Writer::Resume{0.}); })
                .find("another scene"),
            std::string::npos);
}

TEST(Checkpoint, OrARecordThatIsTruncatedSaysHowToBeginAnew)
{
  const Scratch scratch;
  CheckpointFile checkpoint(scratch / "c.h5", scene_of_hash("1"));
  checkpoint.put("tiles", std::vector<int>{1});
  checkpoint.finish();
  {
    Writer writer(scratch / "a.h5", {}, scene_of_hash("1"), false);
  }
  for (const char *name : {"c.h5", "a.h5.part"})
    std::filesystem::resize_file(scratch / name, std::filesystem::file_size(scratch / name) / 2);
  for (const std::string &said :
       {error_of<std::runtime_error>([&]
                                     { Checkpoint::load(scratch / "c.h5", scene_of_hash("1")); }),
        error_of<std::runtime_error>(
            [&] { Writer(scratch / "a.h5", {}, scene_of_hash("1"), Writer::Resume{0.}); })})
    EXPECT_NE(said.find("start without --resume"), std::string::npos) << said;
}

TEST(Checkpoint, GivesEveryTypeBackBitForBit)
{
  const Scratch scratch;
  // A NaN with a payload: even that must not change.
  const unsigned long bits = 0x7ff8000000abcdefUL;
  double strange;
  std::memcpy(&strange, &bits, sizeof strange);
  std::vector<double> x(6000, 1. / 3.);
  x[5999] = strange;
  CheckpointFile before(scratch / "c.h5", scene_of_hash("1"));
  before.put("solid/x", x);
  before.put("melt/phi", std::vector<float>{0.1f, -1.f});
  before.put("tiles", std::vector<int>{-1, 2147483647});
  before.put("flags", std::vector<unsigned char>{0, 255});
  before.put("none", std::vector<double>{});
  before.put("time", std::nextafter(1., 2.));
  before.finish();

  const Checkpoint after = Checkpoint::load(scratch / "c.h5", scene_of_hash("1"));
  EXPECT_EQ(std::memcmp(after.get<double>("solid/x").data(), x.data(), 6000 * sizeof(double)), 0);
  EXPECT_EQ(after.get<float>("melt/phi"), (std::vector<float>{0.1f, -1.f}));
  EXPECT_EQ(after.get<int>("tiles"), (std::vector<int>{-1, 2147483647}));
  EXPECT_EQ(after.get<unsigned char>("flags"), (std::vector<unsigned char>{0, 255}));
  EXPECT_TRUE(after.get<double>("none").empty());
  EXPECT_EQ(after.number("time"), std::nextafter(1., 2.));
  EXPECT_TRUE(after.has("tiles"));
  EXPECT_FALSE(after.has("walls"));
}

TEST(Checkpoint, SaysWhatIsMissing)
{
  const Scratch scratch;
  CheckpointFile file(scratch / "c.h5", scene_of_hash("1"));
  file.put("tiles", std::vector<int>{1});
  file.finish();
  const Checkpoint checkpoint = Checkpoint::load(scratch / "c.h5", scene_of_hash("1"));
  EXPECT_NE(error_of<std::runtime_error>([&] { checkpoint.get<int>("walls"); }).find("walls"),
            std::string::npos);
  EXPECT_NE(error_of<std::runtime_error>([&] { checkpoint.get<double>("tiles"); }).find("type"),
            std::string::npos);
  EXPECT_NE(
      error_of<std::runtime_error>([&] { Checkpoint::load(scratch / "c.h5", scene_of_hash("2")); })
          .find("another scene"),
      std::string::npos);
  EXPECT_NE(
      error_of<std::runtime_error>([&] { Checkpoint::load(scratch / "d.h5", scene_of_hash("1")); })
          .find("--resume"),
      std::string::npos);
}

TEST(Checkpoint, ReplacesTheOneBeforeWhole)
{
  const Scratch scratch;
  const auto value = [&]
  { return Checkpoint::load(scratch / "c.h5", scene_of_hash("1")).number("a"); };
  CheckpointFile first(scratch / "c.h5", scene_of_hash("1"));
  first.put("a", 1.);
  first.finish();
  CheckpointFile second(scratch / "c.h5", scene_of_hash("1"));
  second.put("a", 2.);
  EXPECT_EQ(value(), 1.); // a kill now leaves the one before
  second.finish();
  EXPECT_EQ(value(), 2.);
  EXPECT_FALSE(std::filesystem::exists(scratch / "c.h5.part"));
}
