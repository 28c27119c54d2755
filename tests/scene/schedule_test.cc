#include "scene/schedule.h"

#include <gtest/gtest.h>

namespace scene
{
  // What the rules let pass is looked at, at the end itself.
  TEST(SampleTimes, TakeATimeThatIsRoundedPastTheEndForTheEnd)
  {
    Probe probe;
    probe.times = {0.1, 0.2 * (1. + 0.9 * rounding_of_times)};
    EXPECT_EQ(sample_times(probe, 0.2), (std::vector<double>{0.1, 0.2}));
    probe.times = {0.2, 0.2 * (1. + 0.9 * rounding_of_times)};
    EXPECT_EQ(sample_times(probe, 0.2), std::vector<double>{0.2}) << "once";
  }
} // namespace scene
