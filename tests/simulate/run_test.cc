// Runs that do not come to a good end: what they leave behind. And what a run says of its memory.
#include "run.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "record/reader.h"
#include "scene_of.h"
#include "solid/points.h"

namespace
{
  using simulated::Folder;
  using simulated::scene_of;

  /// Flies out of the domain.
  const std::string thrown =
      "title = \"t\"\n[domain]\nsize = [3.0, 3.0]\ncells = [15, 15]\n"
      "[[body]]\nshape = \"rectangle\"\ncorner = [1.0, 1.0]\nsize = [1.0, 1.0]\n"
      "velocity = [\"5\", \"0\"]\n"
      "[solid]\nyoung_modulus = 1000.0\npoisson_ratio = 0.3\ndensity = 1.0\n"
      "[clock]\nend = 1.0\n";
  /// Its growth step is too long: phi leaves its bounds.
  const std::string outgrown = "title = \"t\"\n[domain]\nsize = [12.8, 12.8]\ncells = [32, 32]\n"
                               "[[body]]\nshape = \"disc\"\ncentre = [6.4, 6.4]\nradius = 4.0\n"
                               "[phase_field]\nwidth = 1.0\n[growth]\ncapillary_length = 0.185\n"
                               "step = 0.05\n[heat]\ndiffusivity = 3.0\nundercooling = 0.55\n"
                               "[clock]\nend = 100.0\nstep = 0.05\n";
  const std::string watched = "[[probe]]\nname = \"energy\"\nhistory = true\nevery = 0.01\n";

  record::CommandLine command_for(const Folder &folder)
  {
    record::CommandLine command;
    command.scene = folder / "scene.toml", command.output = folder / "out";
    command.record = "mpm_pf", command.joined = "mpm_pf scene.toml";
    return command;
  }

  struct Ended
  {
    int code;
    std::string said;
  };

  Ended ended(
      const scene::Scene &scene, const record::CommandLine &command,
      const std::function<bool()> &stop_asked = [] { return false; })
  {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    int code = 0;
    std::string thrown;
    try
    {
      code = run(scene, command, stop_asked);
    }
    catch (const std::exception &error)
    {
      thrown = error.what(); // said once both streams are free again
    }
    testing::internal::GetCapturedStdout();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(thrown, "");
    return {code, said};
  }

  bool says(const std::string &message, const std::string &words)
  {
    return message.find(words) != std::string::npos;
  }

  record::Snapshot last_good(const record::Reader &record)
  {
    EXPECT_EQ(record.snapshot_times("last good state").size(), 1u);
    return record.snapshot("last good state", 0);
  }
} // namespace

TEST(FailedRun, KeepsTheStateBeforeTheTrouble)
{
  const Folder folder;
  const auto scene = scene_of(folder, thrown + watched);
  const auto command = command_for(folder);
  const Ended end = ended(scene, command);
  EXPECT_EQ(end.code, record::numerical_trouble);
  EXPECT_TRUE(says(end.said, "has left the mesh")) << end.said;
  EXPECT_TRUE(says(end.said, "snapshot \"last good state\"")) << end.said;
  EXPECT_TRUE(says(end.said, "nothing to resume")) << end.said;
  const record::Reader record(command.record_path());
  EXPECT_TRUE(says(record.status(), "failed: numerical trouble")) << record.status();
  const double time = record.snapshot_times("last good state").at(0);
  EXPECT_NEAR(time, 0.205, 0.006); // the foremost points leave at 0.21
  const auto points = last_good(record);
  ASSERT_EQ(points.vertex.size(), 100u);
  for (std::size_t p = 0; p < points.vertex.size(); ++p)
    ASSERT_NEAR(points.vertex[p][0], points.fields.at("initial_x")[p] + 5. * time, 1e-9);
  const auto rows = record.table("energy").time;
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(std::lround(time / 0.01)) + 1) << "each once";
  EXPECT_NEAR(rows.back(), time, 1e-12);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/mpm_pf.checkpoint.h5"));
  EXPECT_FALSE(std::filesystem::exists(command.record_path() + ".part"));
}

TEST(FailedRun, KeepsTheStartWhereNothingWasGoodAfterIt)
{
  const Folder folder;
  const auto command = command_for(folder);
  EXPECT_EQ(ended(scene_of(folder, thrown), command).code, record::numerical_trouble);
  const record::Reader record(command.record_path());
  EXPECT_EQ(record.snapshot_times("last good state").at(0), 0.);
  EXPECT_EQ(last_good(record).vertex.size(), 100u);
}

TEST(FailedRun, ComesBackFromItsCheckpointToTheSameState)
{
  const Folder whole, parts;
  EXPECT_EQ(ended(scene_of(whole, thrown + watched), command_for(whole)).code,
            record::numerical_trouble);
  const auto scene = scene_of(parts, thrown + watched);
  auto command = command_for(parts);
  int looks = 0;
  EXPECT_EQ(ended(scene, command, [&] { return ++looks > 12; }).code, record::interrupted);
  command.resume = true;
  EXPECT_EQ(ended(scene, command).code, record::numerical_trouble);
  const record::Reader one(command_for(whole).record_path()), two(command.record_path());
  EXPECT_EQ(one.snapshot_times("last good state"), two.snapshot_times("last good state"));
  EXPECT_EQ(last_good(one).vertex, last_good(two).vertex);
  EXPECT_EQ(last_good(one).fields, last_good(two).fields);
  EXPECT_EQ(one.table("energy").rows, two.table("energy").rows);
}

TEST(FailedRun, KeepsTheMeltBeforeItLeftItsBounds)
{
  const Folder folder;
  const auto scene = scene_of(folder, outgrown);
  auto command = command_for(folder);
  command.force = true;
  const Ended end = ended(scene, command);
  EXPECT_EQ(end.code, record::numerical_trouble);
  EXPECT_TRUE(says(end.said, " has left its bounds")) << end.said;
  const record::Reader record(command.record_path());
  EXPECT_GT(record.snapshot_times("last good state").at(0), 0.);
  const auto good = last_good(record);
  for (const double phi : good.fields.at("phi"))
    ASSERT_LT(std::abs(phi), 2.);
}

// Whatever can be in a checkpoint is good: there is no good state after a bad one. The melt shows
// its trouble after a step, a motion that is singular before the next one begins.
TEST(FailedRun, KeepsTheStateThatItsLastCheckpointCouldHold)
{
  const std::string singular = "title = \"t\"\n[domain]\nsize = [3.0, 3.0]\ncells = [15, 15]\n"
                               "boundary = \"periodic\"\n"
                               "[[body]]\nshape = \"disc\"\ncentre = [1.5, 1.5]\nradius = 1.0\n"
                               "[phase_field]\nwidth = 0.4\n"
                               "[imposed]\nvelocity = [\"1/(0.4871 - t)\", \"0\"]\n"
                               "[clock]\nend = 1.0\n";
  for (const std::string &text : {outgrown, singular})
  {
    const auto fresh = [](const Folder &folder)
    {
      record::CommandLine command = command_for(folder);
      command.force = true;
      return command;
    };
    const auto stopped_after = [](const long step) // asked after each, and before the first
    { return [step, steps = -1L]() mutable { return ++steps >= step; }; };
    const Folder whole, parts, beyond;
    const Ended end = ended(scene_of(whole, text), fresh(whole));
    ASSERT_EQ(end.code, record::numerical_trouble) << end.said;
    const std::string before = "after step ";
    const auto number = end.said.find(before);
    ASSERT_NE(number, std::string::npos) << end.said;
    const long good = std::stol(end.said.substr(number + before.size()));
    ASSERT_GT(good, 0);

    EXPECT_EQ(ended(scene_of(beyond, text), fresh(beyond), stopped_after(good + 1)).code,
              record::numerical_trouble);
    const auto scene = scene_of(parts, text);
    record::CommandLine command = fresh(parts);
    ASSERT_EQ(ended(scene, command, stopped_after(good)).code, record::interrupted);
    command.resume = true;
    EXPECT_EQ(ended(scene, command).code, record::numerical_trouble);
    const record::Reader one(fresh(whole).record_path()), two(command.record_path());
    EXPECT_EQ(one.snapshot_times("last good state"), two.snapshot_times("last good state"));
    EXPECT_EQ(last_good(one).fields, last_good(two).fields);
  }
}

// Where a checkpoint belongs stands a folder: no fault of the scene.
TEST(StoppedRun, IsNoBadInputAndGoesOnWhenTheCauseIsGone)
{
  const Folder folder;
  auto calm = thrown + watched;
  calm.replace(calm.find("\"5\""), 3, "\"0.5\"");
  const auto scene = scene_of(folder, calm);
  auto command = command_for(folder);
  const std::string obstacle = folder / "out/mpm_pf.checkpoint.h5.part";
  std::filesystem::create_directories(obstacle);
  int looks = 0;
  const Ended end = ended(scene, command, [&] { return ++looks > 12; });
  EXPECT_EQ(end.code, record::not_written);
  EXPECT_TRUE(says(end.said, "stopped after step 12 at time 0.12: cannot write")) << end.said;
  EXPECT_TRUE(says(end.said, "start anew, without --resume")) << end.said;
  const auto reason = record::Reader(command.record_path() + ".part").attribute("stopped_by");
  EXPECT_TRUE(says(reason, "cannot write")) << reason;
  std::filesystem::remove(obstacle);
  EXPECT_EQ(ended(scene, command).code, record::all_right);
  EXPECT_EQ(record::Reader(command.record_path()).table("energy").time.size(), 101u);
}

TEST(ResumedRun, NeedsACheckpoint)
{
  const Folder folder;
  auto command = command_for(folder);
  command.resume = true;
  try
  {
    run(scene_of(folder, thrown + watched), command, [] { return false; });
    FAIL() << "it started";
  }
  catch (const std::runtime_error &error)
  {
    EXPECT_TRUE(says(error.what(), "no checkpoint")) << error.what();
    EXPECT_TRUE(says(error.what(), "start without --resume")) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// The work of both starts, counted as that of a run that was never interrupted.
TEST(ResumedRun, RecordsTheCostOfAllItsStarts)
{
  const Folder whole, parts;
  auto calm = thrown + watched;
  calm.replace(calm.find("\"5\""), 3, "\"0.5\"");
  ASSERT_EQ(ended(scene_of(whole, calm), command_for(whole)).code, record::all_right);
  const auto scene = scene_of(parts, calm);
  auto command = command_for(parts);
  int looks = 0;
  const auto slowly = [&]
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return ++looks > 12;
  };
  ASSERT_EQ(ended(scene, command, slowly).code, record::interrupted);
  command.resume = true;
  ASSERT_EQ(ended(scene, command).code, record::all_right);
  const record::Reader one(command_for(whole).record_path()), two(command.record_path());
  const auto a = one.profile(), b = two.profile();
  EXPECT_EQ(one.table("energy").rows, two.table("energy").rows);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t k = 0; k < a.parts.size(); ++k)
  {
    EXPECT_EQ(a.parts[k].name, b.parts[k].name);
    const bool once_a_start = a.parts[k].name == "set-up" || a.parts[k].name == "output";
    EXPECT_EQ(a.parts[k].calls * (once_a_start ? 2 : 1), b.parts[k].calls) << a.parts[k].name;
  }
  EXPECT_GE(b.parts.at(1).wall_s, 13 * 0.02) << "of " << b.parts.at(1).name;
  EXPECT_GE(b.numbers.at("wall_s"), 13 * 0.02);
}

TEST(Run, SaysWhatItIsAboutToDo)
{
  const Folder folder;
  auto calm = thrown;
  calm.replace(calm.find("\"5\""), 3, "\"0.5\"");
  const Ended end = ended(scene_of(folder, calm), command_for(folder));
  EXPECT_EQ(end.code, record::all_right);
  // Wave speed 36.7: 1/(0.4 * 0.2/37.2) steps.
  EXPECT_TRUE(says(end.said, "size: 15 x 15 cells, 100 points, about 465 steps of the solid"))
      << end.said;
}

// A crystal that melts away: its points were most at the start.
TEST(Run, RecordsTheMostThatItHasHeld)
{
  const Folder folder;
  const auto scene =
      scene_of(folder, "title = \"t\"\n[units]\nsystem = \"W0-tau0-sigmaY\"\n"
                       "[domain]\nsize = [16.0, 16.0]\ncells = [40, 40]\nboundary = \"symmetry\"\n"
                       "[[body]]\nshape = \"disc\"\ncentre = [0.0, 0.0]\nradius = 8.0\n"
                       "[phase_field]\nwidth = 1.0\n[growth]\ncapillary_length = 0.185\n"
                       "[heat]\ndiffusivity = 3.0\nundercooling = 0.0\ninitial = 0.5\n"
                       "[solid]\nyoung_modulus = 1e4\npoisson_ratio = 0.33\ndensity = 1e3\n"
                       "[[probe]]\nname = \"h\"\nhistory = true\nevery = 0.5\n"
                       "[clock]\nend = 10.0\n");
  const auto command = command_for(folder);
  ASSERT_EQ(ended(scene, command).code, record::all_right);
  const record::Reader record(command.record_path());
  const double kept = record.number("points"), most = record.number("bytes solid points");
  EXPECT_LT(kept, 800.);
  // A quarter of a disc of 8 holds 50.3/0.16 cells of four points.
  EXPECT_NEAR(most, 1257. * static_cast<double>(solid::bytes_per_point()), 0.05 * most);
}
