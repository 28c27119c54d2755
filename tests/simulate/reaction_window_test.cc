#include "reaction_window.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{
  using scene::Point;

  /// Rows of a window that is shown impulse(t) at all its events.
  template <class Impulse>
  std::vector<ReactionRow> rows_of(ReactionWindow &window, std::vector<double> events,
                                   const Impulse &impulse)
  {
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    std::vector<ReactionRow> rows;
    for (const double t : events)
      for (const auto &row : window.add(t, Point(impulse(t), 0.), Point(0., 2. * t)))
        rows.push_back(row);
    return rows;
  }
} // namespace

// A force 3 + 4t has the impulse 3t + 2t^2; central differences and linear extrapolation are exact.
TEST(ReactionWindow, IsExactForALinearForceUpToBothEnds)
{
  ReactionWindow window({{0., 0.25, 0.5, 0.75, 1.}, 0.125, 1.});
  const auto rows = rows_of(window, window.events(), [](double t) { return 3. * t + 2. * t * t; });
  ASSERT_EQ(rows.size(), 5u);
  for (const auto &row : rows)
  {
    EXPECT_NEAR(row.force[0], 3. + 4. * row.time, 1e-12);
    EXPECT_DOUBLE_EQ(row.displacement[1], 2. * row.time);
  }
}

// Walls may end a run between two samples; the last moment counts then, by the same rule.
TEST(ReactionWindow, ReachesToWhereTheRunEndsEarly)
{
  const auto impulse = [](double t) { return 3. * t + 2. * t * t; };
  for (const double stop : {0.6, 0.66, 0.75, 0.8})
  {
    ReactionWindow window({{0., 0.25, 0.5, 0.75, 1.}, 0.125, 1.});
    std::vector<double> events;
    for (const double t : window.events())
      if (t <= stop)
        events.push_back(t);
    auto rows = rows_of(window, events, impulse);
    window.end_early(stop);
    for (const auto &row : window.add(stop, Point(impulse(stop), 0.), Point(0., 2. * stop)))
      rows.push_back(row);
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows.back().time, stop);
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
      EXPECT_NEAR(rows[k].force[0], 3. + 4. * rows[k].time, 1e-12) << stop;
      EXPECT_DOUBLE_EQ(rows[k].displacement[1], 2. * rows[k].time);
      EXPECT_EQ(rows[k].time, k + 1 < rows.size() ? 0.25 * k : stop) << "none is left out";
    }
  }
}

// Between a quarter of half a window and half a window after the start both rows have one window.
TEST(ReactionWindow, GivesTheMeanWhereARunEndsInItsFirstWindow)
{
  for (const double stop : {0.02, 0.05, 0.1, 0.125})
  {
    ReactionWindow window({{0., 0.25, 0.5, 0.75, 1.}, 0.125, 1.});
    auto rows = rows_of(window, {0.}, [](double) { return 0.; });
    window.end_early(stop);
    const double impulse = 3. * stop + 2. * stop * stop;
    for (const auto &row : window.add(stop, Point(impulse, 0.), Point(0., 2. * stop)))
      rows.push_back(row);
    ASSERT_FALSE(rows.empty()) << stop;
    EXPECT_EQ(rows.back().time, stop);
    for (const auto &row : rows)
      EXPECT_NEAR(row.force[0], 3. + 2. * stop, 1e-12) << stop << " at " << row.time;
  }
}

TEST(ReactionWindow, AveragesRingingAway)
{
  const double ring = 2. * std::acos(-1.) / 0.25; // one period in the window
  ReactionWindow window({{0., 0.25, 0.5, 0.75, 1.}, 0.125, 1.});
  const auto rows =
      rows_of(window, window.events(), [&](double t) { return t + std::sin(ring * t) / ring; });
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_NEAR(rows[2].force[0], 1., 1e-12);
}

TEST(ReactionWindow, GoesOnFromItsState)
{
  ReactionWindow whole({{0., 0.5, 1.}, 0.25, 1.}), first = whole, second = whole;
  const auto impulse = [](double t) { return t * t * t; };
  const auto all = rows_of(whole, whole.events(), impulse);
  auto rows = rows_of(first, {0., 0.25, 0.5}, impulse);
  second.restore(first.state());
  const auto rest = rows_of(second, {0.75, 1.}, impulse);
  rows.insert(rows.end(), rest.begin(), rest.end());
  ASSERT_EQ(rows.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(rows[i].force[0], all[i].force[0]);
}
