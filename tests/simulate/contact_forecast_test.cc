// What a run costs in all, estimated at contact from the pace of the first steps with points.
#include "contact_forecast.h"

#include <gtest/gtest.h>

namespace
{
  /// A run that grew for 40 s and was met by a wall at time 100; it ends at 200.
  RunProgress at_contact()
  {
    return {100., 200., 1000, 40.};
  }

  /// So many steps later, of `length` each, which took 0.5 s each.
  RunProgress later(const long steps, const double length)
  {
    RunProgress now = at_contact();
    now.time += static_cast<double>(steps) * length;
    now.steps += steps;
    now.cpu_s += 0.5 * static_cast<double>(steps);
    return now;
  }
} // namespace

TEST(ContactForecast, CarriesThePaceAfterContactOnToTheEnd)
{
  ContactForecast forecast;
  forecast.add(at_contact());
  EXPECT_FALSE(forecast.cpu_s());
  forecast.add(later(20, 0.2)); // 10 s for 4 of 100: 250 s in all after contact
  ASSERT_TRUE(forecast.cpu_s());
  EXPECT_NEAR(*forecast.cpu_s(), 290., 1e-9);
  forecast.add(later(40, 0.5)); // what comes later does not change what was said
  EXPECT_NEAR(*forecast.cpu_s(), 290., 1e-9);
}

TEST(ContactForecast, WaitsForStepsAndForWay)
{
  ContactForecast forecast;
  forecast.add(at_contact());
  forecast.add(later(9, 1.)); // few steps
  EXPECT_FALSE(forecast.cpu_s());
  forecast.add(later(19, 0.1)); // 1.9 of 100
  EXPECT_FALSE(forecast.cpu_s());
  forecast.add(later(21, 0.1));
  EXPECT_TRUE(forecast.cpu_s());
}

TEST(ContactForecast, OfACheckpointStays)
{
  ContactForecast forecast;
  forecast.restore(300.);
  forecast.add(at_contact());
  forecast.add(later(20, 0.2));
  EXPECT_EQ(*forecast.cpu_s(), 300.);
}
