// Child processes: whose time counts, what an end is, and what becomes of the exit codes of
// scripts.
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "commands.h"
#include "process.h"
#include "section.h"
#include "workspace.h"

using namespace verify;

namespace
{
  Command shell_command(const Workspace &w, const std::string &line)
  {
    Command command;
    command.arguments = {"/bin/sh", "-c", line};
    command.log = (w.root / "log").string();
    return command;
  }

  /// Polls until the child has ended; the largest CPU time that was seen meanwhile in `cpu_s`.
  std::optional<ProcessResult> end_of(Process &process, double &cpu_s)
  {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(60))
    {
      if (const auto ended = process.poll())
        return ended;
      cpu_s = std::max(cpu_s, process.cpu_s());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {};
  }
} // namespace

// As mpirun does: what computes is a child, in a process group of its own.
TEST(Processes, CountTheTimeOfAllThatTheyStarted)
{
  const Workspace w;
  const std::string fake = w.paths().solver("mpm_pf");
  Process process(shell_command(w, "set -m; " + fake + " s.toml --output " + w.root.string() +
                                       " --set fake.burn=0.8 & wait"));
  double cpu_s = 0.;
  const auto ended = end_of(process, cpu_s);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 0) << w.read("log");
  EXPECT_GT(cpu_s, 0.4); // looked at five times a second; the shell itself takes milliseconds
}

// Linux hands the high-water mark of a process on to what it forks.
TEST(Processes, AreNotChargedForTheMemoryOfTheProgramThatStartsThem)
{
  const Workspace w;
  const std::vector<char> held(200'000'000, 1);
  Process process(shell_command(w, "sleep 0.3"));
  double ignored = 0.;
  const auto ended = end_of(process, ignored);
  ASSERT_TRUE(ended);
  EXPECT_GT(ended->peak_rss_bytes, 1e5);
  EXPECT_LT(ended->peak_rss_bytes, 0.5 * static_cast<double>(held.size()));
}

TEST(Processes, ThatSomebodyElseWaitedForHaveEnded)
{
  const Workspace w;
  const auto old = std::signal(SIGCHLD, SIG_IGN); // the system waits for them
  Process process(shell_command(w, "exit 0"));
  double ignored = 0.;
  const auto ended = end_of(process, ignored);
  std::signal(SIGCHLD, old);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, -1);
}

TEST(Jobs, ThatWaitForEachOtherAreRefused)
{
  std::vector<Job> jobs(2);
  jobs[0].after = {1}, jobs[1].after = {0};
  EXPECT_THROW(run_jobs(jobs, {1, true}), std::logic_error);
}

TEST(Scripts, MayLieInAFolderWithBlanksAndKeepTheirExitCodes)
{
  const Workspace w;
  Paths places = w.paths();
  places.postprocess = (w.root / "post process's").string();
  w.write("post process's/ends.py", "import sys\nsys.exit(int(sys.argv[1]))\n");
  w.write("post process's/killed.py", "import os\nos.kill(os.getpid(), 9)\n");
  EXPECT_EQ(run_python(places, "ends.py", {"7"}), 7);
  EXPECT_EQ(run_python(places, "ends.py", {"0"}), 0);
  EXPECT_EQ(run_python(places, "killed.py", {}), 128 + 9);
}

TEST(Scripts, OfFiguresSayThatThereIsNothingToDraw)
{
  const Workspace w;
  for (const auto &[ends_with, code] : {std::pair{0, 0}, {1, 1}, {4, 4}, {2, 2}, {77, 2}})
  {
    w.write("postprocess/figures.py", "import sys\nsys.exit(" + std::to_string(ends_with) + ")\n");
    EXPECT_EQ(figures(w.paths(), "anywhere"), code) << ends_with;
  }
}
