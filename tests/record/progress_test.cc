// Progress goes where it is sent and nowhere else.
#include <chrono>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "record/progress.h"

using record::Progress;

TEST(Progress, PrintsDurationsForPeople)
{
  EXPECT_EQ(Progress::duration(0.44), "0.4 s");
  EXPECT_EQ(Progress::duration(9.96), "10 s");
  EXPECT_EQ(Progress::duration(59.7), "1 min 00 s");
  EXPECT_EQ(Progress::duration(200.), "3 min 20 s");
  EXPECT_EQ(Progress::duration(3599.9), "1 h 00 min");
  EXPECT_EQ(Progress::duration(3720.), "1 h 02 min");
}

TEST(Progress, IsSilentWhenQuietAndRareInALog)
{
  std::ostringstream quiet, log;
  Progress nothing(quiet, Progress::Style::quiet, "mpm_pf shear", {0., 1.});
  Progress lines(log, Progress::Style::log, "mpm_pf shear", {0., 1.});
  for (int k = 0; k <= 1000; ++k)
  {
    nothing.update(k / 1000.);
    lines.update(k / 1000.);
  }
  EXPECT_EQ(log.str(), ""); // 30 s have not passed
  nothing.finish();
  lines.finish();
  EXPECT_EQ(quiet.str(), "");
  EXPECT_EQ(log.str().rfind("mpm_pf shear: done in ", 0), 0u);
  EXPECT_EQ(log.str().back(), '\n');
}

TEST(Progress, ForetellsFromThePaceOfLate)
{
  std::ostringstream out;
  Progress progress(out, Progress::Style::terminal, "mpm_pf shear", {0., 1.}, 0.25);
  // Nine tenths of the way in a moment, then a ten-thousandth per quarter of a second.
  double fraction = 0.9;
  for (int k = 0; k < 4; ++k, fraction += 1e-4)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(270));
    progress.update(fraction);
  }
  const std::string last = out.str().substr(out.str().rfind('\r'));
  EXPECT_NE(last.find("min"), std::string::npos) << last; // 0.1/1e-4 of 0.27 s, not 0.1 s
  progress.set_end(0.9008);                               // walls will end it sooner
  std::this_thread::sleep_for(std::chrono::milliseconds(270));
  progress.update(fraction);
  const std::string sooner = out.str().substr(out.str().rfind('\r'));
  EXPECT_EQ(sooner.find("min"), std::string::npos) << sooner;
}
