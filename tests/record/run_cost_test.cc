// The cost of a run that was interrupted is that of all its starts.
#include <chrono>
#include <thread>

#include "../scratch.h"
#include "record/run_cost.h"

namespace
{
  using namespace record;

  void wait()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  const Profile::Part &part(const Profile &profile, const std::string &name)
  {
    for (const Profile::Part &one : profile.parts)
      if (one.name == name)
        return one;
    throw std::out_of_range(name);
  }

  /// 20 ms of set-up, 20 ms of solve.
  void spend(RunCost &cost)
  {
    wait();
    cost.set_up_done();
    wait();
  }

  Profile interrupted(const Scratch &scratch)
  {
    RunCost cost;
    spend(cost);
    SolverCost solver;
    solver.output.wall_s = 0.25;
    solver.steps = 10;
    solver.parts = {{"growth", 2., 1., 10}, {"walls", 0.5, 0.25, 4}};
    solver.numbers = {{"bytes a", 700.}, {"noise_calls", 3.}, {"points", 9.}};
    const Profile spent = cost.profile(solver);
    CheckpointFile file(scratch / "c.h5", {});
    save(spent, file);
    file.finish();
    return spent;
  }

  Profile resumed(const Scratch &scratch)
  {
    RunCost cost;
    cost.resume(Checkpoint::load(scratch / "c.h5", {}));
    spend(cost);
    SolverCost solver;
    solver.output.wall_s = 0.5;
    solver.steps = 15;
    solver.parts = {{"growth", 1., 0.5, 5}, {"heat", 3., 3., 5}};
    solver.numbers = {{"bytes a", 600.}, {"noise_calls", 2.}, {"points", 8.}};
    return cost.profile(solver);
  }
} // namespace

TEST(RunCost, AddsWhatWasSpentBeforeTheCheckpoint)
{
  const Scratch scratch;
  const Profile before = interrupted(scratch), whole = resumed(scratch);
  EXPECT_EQ(part(whole, "growth").wall_s, 3.);
  EXPECT_EQ(part(whole, "growth").cpu_s, 1.5);
  EXPECT_EQ(part(whole, "growth").calls, 15);
  EXPECT_EQ(part(whole, "heat").calls, 5) << "only of the later start";
  EXPECT_EQ(part(whole, "walls").calls, 4) << "only of the earlier start";
  EXPECT_EQ(part(whole, "output").wall_s, 0.75);
  EXPECT_EQ(part(whole, "set-up").calls, 2);
  EXPECT_EQ(whole.numbers.at("noise_calls"), 5.);
  EXPECT_GE(part(whole, "set-up").wall_s, part(before, "set-up").wall_s + 0.02);
  EXPECT_GE(whole.numbers.at("wall_s"), before.numbers.at("wall_s") + 0.04);
  EXPECT_GE(whole.numbers.at("cpu_s"), 2. * before.numbers.at("cpu_s")) << "of one process here";
}

TEST(RunCost, CountsStepsOfTheWholeRunOnceAndTakesTheMostOfBytes)
{
  const Scratch scratch;
  const Profile before = interrupted(scratch), whole = resumed(scratch);
  EXPECT_EQ(part(before, "solve").calls, 10);
  EXPECT_EQ(part(whole, "solve").calls, 15);
  EXPECT_EQ(whole.numbers.at("bytes a"), 700.);
  EXPECT_EQ(whole.numbers.at("points"), 8.) << "what it is now";
  EXPECT_GE(whole.numbers.at("peak_rss_bytes"), before.numbers.at("peak_rss_bytes"));
}

TEST(RunCost, KnowsWhatTheCheckpointHolds)
{
  const Scratch scratch;
  const Profile before = interrupted(scratch);
  RunCost cost;
  EXPECT_FALSE(cost.earlier("points"));
  cost.resume(Checkpoint::load(scratch / "c.h5", {}));
  EXPECT_EQ(cost.earlier("points"), std::optional<double>(9.));
  EXPECT_FALSE(cost.earlier("forecast")) << "it had none";
  EXPECT_GE(cost.cpu_seconds(), 2. * before.numbers.at("cpu_s")) << "of one process here";
}

TEST(RunCost, IsTheSumOfSetUpSolveAndOutput)
{
  const Scratch scratch;
  for (const Profile &profile : {interrupted(scratch), resumed(scratch)})
  {
    double wall = 0., cpu = 0.;
    for (const char *name : {"set-up", "solve", "output"})
      wall += part(profile, name).wall_s, cpu += part(profile, name).cpu_s;
    EXPECT_NEAR(wall, profile.numbers.at("wall_s"), 1e-12);
    EXPECT_NEAR(cpu, profile.numbers.at("cpu_s"), 1e-12);
  }
}
